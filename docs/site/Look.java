import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Looks at the site that {@code mvn -Psite -N site} has made: all links and what search finds lead to pages, headings and files that are there; opened in Chromium without a window, as wide as a phone, a
 * tablet and a desk, light and dark, no page is wider than it may be, no picture is missing, no words are hard to read, and search finds.
 * <pre>java docs/site/Look.java target/site</pre>
 */
class Look {
    private static final Pattern LINK = Pattern.compile("(?:href|src)=\"([^\"]*)\"");
    private static final Pattern FOUND = Pattern.compile("(?m)^\\[\"([^\"]*)\"");
    /** Of words and what is behind them, as WCAG 2 asks for (level AA). */
    private static final String LEAST_CONTRAST = "4.5";
    private static final String LOOK = """
            <body><pre id="said"></pre><script>
            const said = [], pages = PAGES;
            const parts = color => (color.match(/[\\d.]+/g) || [0, 0, 0, 0]).map(Number);
            const light = ([r, g, b]) => [r, g, b].map(c => c / 255).map(c => c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4).reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
            async function look(frame, width, page) {
              await new Promise(done => { frame.onload = () => setTimeout(done, 50); frame.src = page; });
              const inside = frame.contentDocument, style = one => frame.contentWindow.getComputedStyle(one), tell = what => said.push(`${page}, ${width} wide: ${what}`);
              if (inside.documentElement.scrollWidth > width) { tell('is wider than its window'); }
              for (const picture of inside.images) { if (!picture.naturalWidth) { tell('no picture ' + picture.getAttribute('src')); } }
              let worst = 99, where = '';
              for (const one of inside.body.querySelectorAll('*')) {
                if (![...one.childNodes].some(node => node.nodeType === 3 && node.data.trim()) || !one.getClientRects().length || one.closest('script, style')) { continue; }
                let behind = one;
                while (behind && !(parts(style(behind).backgroundColor)[3] ?? 1)) { behind = behind.parentElement; }
                const a = light(parts(style(one).color)), b = behind ? light(parts(style(behind).backgroundColor)) : 1, contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
                if (contrast < worst) { worst = contrast; where = one.textContent.trim().slice(0, 30); }
              }
              if (worst < LEAST) { tell(`"${where}" is hard to read, contrast ${worst.toFixed(1)}`); }
            }
            (async () => {
              for (const width of [390, 768, 1280]) {
                const frame = document.createElement('iframe');
                frame.style.cssText = `width:${width}px;height:900px;border:0`;
                document.body.append(frame);
                for (const page of pages) { await look(frame, width, page); }
                await look(frame, width, pages[0] + '?q=torus');
                if (!frame.contentDocument.querySelector('#search li a')) { said.push('search finds no torus'); }
              }
              document.getElementById('said').textContent = '\\u00ab' + said.join('\\n') + '\\u00bb';
            })();
            </script>""";

    public static void main(String[] words) throws Exception {
        Path site = Path.of(words.length == 0 ? "target/site" : words[0]).toAbsolutePath().normalize();
        List<Path> pages;
        try (Stream<Path> all = Files.walk(site)) {
            pages = all.filter(file -> file.toString().endsWith(".html")).sorted(Comparator.comparing(page -> !page.equals(site.resolve("index.html")))).toList();
        }
        List<String> wrong = new ArrayList<>(links(site, pages));
        String chromium = Stream.of(System.getenv("PATH").split(java.io.File.pathSeparator)).flatMap(folder -> Stream.of("chromium", "chromium-browser", "google-chrome").map(name -> Path.of(folder, name)))
                .filter(Files::isExecutable).findFirst().map(Path::toString).orElse("");
        if (chromium.isEmpty()) {
            System.out.println("There is no Chromium in the path: pages were not opened.");
        } else {
            for (String theme : List.of("1", "0")) {
                opened(chromium, theme, pages).forEach(one -> wrong.add((theme.equals("0") ? "dark: " : "light: ") + one.replace(site.toUri().toString(), "")));
            }
        }
        wrong.forEach(System.out::println);
        System.out.println(pages.size() + " pages, " + wrong.size() + " faults");
        System.exit(wrong.isEmpty() ? 0 : 1);
    }

    private static List<String> links(Path site, List<Path> pages) throws IOException {
        Map<Path, Set<String>> names = new HashMap<>();
        List<String> lost = new ArrayList<>();
        for (Path page : pages) {
            names.put(page, Pattern.compile("(?:id|name)=\"([^\"]*)\"").matcher(Files.readString(page)).results().map(one -> one.group(1)).collect(Collectors.toSet()));
        }
        for (Path page : pages) {
            LINK.matcher(Files.readString(page)).results().forEach(link -> check(page, link, names, lost));
        }
        Path index = site.resolve("search-index.js");
        FOUND.matcher(Files.readString(index)).results().forEach(link -> check(index, link, names, lost));
        return lost;
    }

    private static void check(Path from, MatchResult link, Map<Path, Set<String>> names, List<String> lost) {
        String[] parts = link.group(1).replace("&amp;", "&").split("#", 2);
        if (parts[0].matches("\\w+:.*")) {
            return;
        }
        Path target = parts[0].isEmpty() ? from : from.resolveSibling(parts[0]).normalize();
        if (!Files.exists(target) || (parts.length > 1 && names.containsKey(target) && !names.get(target).contains(parts[1]))) {
            lost.add(from.getFileName() + ": " + link.group(1) + " leads nowhere");
        }
    }

    private static List<String> opened(String chromium, String theme, List<Path> pages) throws Exception {
        Path folder = Files.createTempDirectory("look");
        try {
            return opened(chromium, theme, pages, folder);
        } finally {
            delete(folder);
        }
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path one : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(one);
            }
        }
    }

    private static List<String> opened(String chromium, String theme, List<Path> pages, Path folder) throws Exception {
        String list = pages.stream().map(page -> '"' + page.toUri().toString() + '"').collect(Collectors.joining(",", "[", "]"));
        Path looks = Files.writeString(folder.resolve("look.html"), LOOK.replace("PAGES", list).replace("LEAST", LEAST_CONTRAST));
        Process process = new ProcessBuilder(chromium, "--headless=new", "--no-sandbox", "--disable-gpu", "--allow-file-access-from-files", "--user-data-dir=" + folder.resolve("profile"),
                "--blink-settings=preferredColorScheme=" + theme, "--virtual-time-budget=300000", "--dump-dom", looks.toUri().toString()).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        String dom;
        try {
            dom = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        } finally {
            process.destroy();
            process.waitFor();
        }
        int begin = dom.indexOf('\u00ab');
        int end = dom.indexOf('\u00bb');
        if (begin < 0 || end < begin) {
            return List.of("Chromium did not come to the end");
        }
        return dom.substring(begin + 1, end).lines().filter(line -> !line.isBlank()).toList();
    }
}
