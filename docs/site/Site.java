import cz.paprsek.asset.Assets;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What the site has beyond the pages as they are: a picture below each scene that a page shows, rendered from just that, and an index to search. Run by the profile {@code site}:
 * <pre>java -cp rt-cli/target/rt-cli.jar docs/site/Site.java target/pages</pre>
 */
class Site {
    private static final Pattern EXAMPLE = Pattern.compile("```xml\n(<.*?)```\n", Pattern.DOTALL);
    private static final String PLACE = "<!-- here -->";
    private static final int WIDTH = 360;
    /** How many letters of code stand in a cell of a table without a break. */
    private static final int LONG = 36;
    /** What examples name lies where the shipped scenes are. */
    private static final Assets FILES = Assets.beside(Path.of("scenes", "example.xml"));

    public static void main(String[] words) throws Exception {
        Path root = Path.of(words[0], "markdown");
        StringBuilder index = new StringBuilder("window.PAPRSEK_PAGES = [\n");
        int pictures = 0;
        List<Path> pages;
        try (Stream<Path> all = Files.walk(root)) {
            pages = all.filter(file -> file.toString().endsWith(".md")).sorted().toList();
        }
        for (Path page : pages) {
            String text = linked(page, Files.readString(page), root);
            String link = root.relativize(page).toString().replace('\\', '/').replaceFirst("md$", "html");
            index(link, text, index);
            StringBuilder with = new StringBuilder();
            String stage = "";
            Matcher example = EXAMPLE.matcher(text);
            while (example.find()) {
                String xml = example.group(1);
                String shown = "";
                if (xml.contains(PLACE)) {
                    stage = xml;
                } else if (!text.startsWith("\n![", example.end()) && (xml.startsWith("<scene") || !stage.isEmpty())) {
                    Scene scene = scene(xml.startsWith("<scene") ? xml : stage.replace(PLACE, xml));
                    String name = link.replaceAll("\\.html$", "").replace('/', '-') + "-" + ++pictures + ".png";
                    Path picture = Path.of(words[0], "resources", "docs", "shown", name);
                    Files.createDirectories(picture.getParent());
                    ImageFiles.write(Renderer.render(prepared(scene), RenderOptions.of(small(scene)), RenderMonitor.NONE).image(), picture);
                    shown = "\n![" + (xml.startsWith("<scene") ? "This scene" : xml.replaceAll("(?s)^<([\\w-]+).*", "$1")) + "](" + "../".repeat(link.split("/").length - 1) + "docs/shown/" + name + ")\n";
                }
                example.appendReplacement(with, Matcher.quoteReplacement(example.group() + shown));
            }
            Files.writeString(page, tables(example.appendTail(with).toString()));
        }
        Files.writeString(Path.of(words[0], "resources", "search-index.js"), index.append("];\n"));
        System.out.println(pages.size() + " pages, " + pictures + " pictures");
    }

    /** A bar in code in a table is written with a backslash, which would be seen here; and what is long there has to go to the next line. */
    private static String tables(String text) {
        return Pattern.compile("(?m)^\\|.*").matcher(text).replaceAll(row -> Matcher.quoteReplacement(Pattern.compile("`([^`]+)`").matcher(row.group()).replaceAll(code -> {
            String words = code.group(1).replace("\\|", "|");
            return Matcher.quoteReplacement(words.length() > LONG || !words.equals(code.group(1)) ? pieces(words) : code.group());
        })));
    }

    /** Options each by themselves, if the whole is long, so that lines end between them and not at their hyphens. */
    private static String pieces(String text) {
        return Pattern.compile(text.length() > LONG ? " (?=-)" : "$").splitAsStream(text)
                .map(piece -> (piece.length() > LONG ? "<code class=\"long\">" : "<code>") + entities(piece) + "</code>").collect(Collectors.joining(" "));
    }

    /** As it is, whatever Markdown makes of two hyphens, quotes and bars. */
    private static String entities(String text) {
        return text.chars().mapToObj(c -> Character.isLetterOrDigit(c) || c == ' ' ? Character.toString(c) : "&#" + c + ";").collect(Collectors.joining());
    }

    /** With links as the site has them: to where the README has gone, and to headings by the names that they get there. One that leads nowhere ends the build. */
    private static String linked(Path page, String text, Path root) {
        return Pattern.compile("\\]\\((?!\\w+:)([^)#\\s]*)(?:#([^)\\s]+))?\\)").matcher(text).replaceAll(link -> {
            Path target = link.group(1).isEmpty() ? page : page.resolveSibling(link.group(1)).normalize();
            target = target.equals(root.resolve("README.md")) ? root.resolve("index.md") : target;
            String anchor = link.group(2) == null ? "" : anchor(target, link.group(2));
            if ((anchor.isEmpty() && link.group(2) != null) || !Files.exists(target) && !Files.exists(root.resolveSibling("resources").resolve(root.relativize(target)))) {
                throw new IllegalStateException(root.relativize(page) + ": " + link.group() + " leads nowhere");
            }
            String path = link.group(1).isEmpty() ? "" : page.getParent().relativize(target).toString().replace('\\', '/').replaceFirst("\\.md$", ".html");
            return Matcher.quoteReplacement("](" + path + (anchor.isEmpty() ? "" : "#" + anchor) + ")");
        });
    }

    /** What the site calls a heading that links call by small letters and hyphens; empty if there is none. */
    private static String anchor(Path page, String link) {
        try {
            return Pattern.compile("(?m)^#+ (.*)$").matcher(Files.readString(page)).results().map(heading -> heading.group(1))
                    .filter(heading -> heading.toLowerCase(Locale.ROOT).replaceAll("(?U)[^\\w\\- ]", "").replace(' ', '-').equals(link)).map(Site::id).findFirst().orElse("");
        } catch (IOException e) {
            return "";
        }
    }

    /** As Doxia makes names of headings. */
    private static String id(String heading) {
        StringBuilder id = new StringBuilder();
        for (byte one : heading.replace("`", "").strip().getBytes(StandardCharsets.UTF_8)) {
            boolean isPlain = one > 0 && (Character.isLetterOrDigit(one) || "-_:.".indexOf(one) >= 0);
            id.append(one == ' ' ? "_" : isPlain ? String.valueOf((char) one) : String.format(Locale.ROOT, ".%02X", one & 0xff));
        }
        return id.isEmpty() || Character.isLetter(id.charAt(0)) ? id.toString() : "a" + id;
    }

    /** At its first frame, if anything moves there. */
    private static Scene scene(String xml) throws Exception {
        return SceneFiles.contents(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "example", Map.of(), FILES).scenes().get(0);
    }

    private static Scene small(Scene scene) {
        return scene.withSettings(scene.settings().withSize(WIDTH, WIDTH * scene.settings().height() / scene.settings().width()));
    }

    /** What moves is seen as in its first frame, blurred while the shutter is open. */
    private static RenderScene prepared(Scene scene) {
        boolean moves = SceneFiles.moves(scene);
        DoubleFunction<Scene> frames = SceneFiles.frames(scene);
        double shutter = scene.settings().shutter();
        RenderScene prepared = RenderScene.of(small(moves ? frames.apply(1) : scene), FILES, RenderMonitor.NONE);
        return moves && shutter > 0 ? prepared.exposed(share -> small(frames.apply(1 + shutter * share)), RenderMonitor.NONE) : prepared;
    }

    /** An entry for each section: page, heading, and its words. */
    private static void index(String link, String text, StringBuilder into) {
        String title = "";
        for (String section : text.split("(?m)^(?=#+ )")) {
            Matcher heading = Pattern.compile("^#+ (.*)\n").matcher(section);
            String name = heading.find() ? heading.group(1) : "";
            title = title.isEmpty() ? name : title;
            String words = section.replaceAll("!?\\[([^\\]]*)\\]\\([^)]*\\)", "$1").replaceAll("[#`*|]", " ").replaceAll("\\s+", " ").strip();
            if (!words.isEmpty()) {
                into.append("[").append(quoted(name.equals(title) ? link : link + "#" + id(name))).append(",").append(quoted(title)).append(",").append(quoted(name)).append(",").append(quoted(words)).append("],\n");
            }
        }
    }

    private static String quoted(String text) {
        StringBuilder out = new StringBuilder("\"");
        for (char letter : text.toCharArray()) {
            out.append(letter == '"' || letter == '\\' ? "\\" + letter : letter < ' ' || letter == '<' || letter > '\u2027' && letter < '\u202a' ? String.format(Locale.ROOT, "\\u%04x", (int) letter) : String.valueOf(letter));
        }
        return out.append('"').toString();
    }
}
