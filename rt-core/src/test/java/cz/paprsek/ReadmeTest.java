package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What the README and the pages beside it show works as it stands there. */
class ReadmeTest {
    private static final Path README = Path.of("../README.md");
    /** Where the examples below a scene stand in it. */
    private static final String STAGE = "<!-- here -->";

    static Stream<String> javaExamples() throws IOException {
        return blocks("java");
    }

    static Stream<String> sceneExamples() throws IOException {
        return blocks("xml").filter(xml -> xml.startsWith("<scene") && !xml.contains(STAGE));
    }

    private static boolean isDependency(String xml) {
        return xml.startsWith("<dependency>");
    }

    @Test
    void theCoordinatesAreThoseOfTheBuild() throws IOException {
        String build = Files.readString(Path.of("../pom.xml"));
        Matcher version = Pattern.compile("<version>(.*?)</version>").matcher(build);
        assertThat(version.find()).isTrue();
        assertThat(blocks("xml").filter(ReadmeTest::isDependency).toList()).singleElement().asString()
                .contains("<groupId>cz.paprsek</groupId>", "<artifactId>rt-core</artifactId>", version.group());
        assertThat(Files.readString(Path.of("../jreleaser.yml"))).contains("\n  version: " + version.group(1) + "\n");
    }

    /** The README first, then all others. */
    private static Map<Path, String> pages() throws IOException {
        Map<Path, String> pages = new LinkedHashMap<>();
        pages.put(README, Files.readString(README));
        for (String folder : List.of("../docs", "../docs/cs")) {
            pages.putAll(pages(folder));
        }
        return pages;
    }

    private static Map<Path, String> pages(String folder) throws IOException {
        Map<Path, String> pages = new LinkedHashMap<>();
        try (Stream<Path> files = Files.list(Path.of(folder))) {
            for (Path page : files.filter(file -> file.toString().endsWith(".md")).sorted().toList()) {
                pages.put(page, Files.readString(page));
            }
        }
        return pages;
    }

    private static Stream<String> blocks(String language) throws IOException {
        Matcher matcher = Pattern.compile("```" + language + "\n(.*?)```", Pattern.DOTALL).matcher(String.join("\n", pages().values()));
        List<String> found = matcher.results().map(result -> result.group(1)).toList();
        assertThat(found).as("examples in %s", language).isNotEmpty();
        return found.stream();
    }

    @ParameterizedTest
    @MethodSource("javaExamples")
    void everyProgramCompiles(String source, @TempDir Path folder) {
        compile(source, folder);
    }

    static Stream<String> programsWithoutFiles() throws IOException {
        return javaExamples().filter(source -> !source.contains("Path"));
    }

    @ParameterizedTest
    @MethodSource("programsWithoutFiles")
    void everyProgramThatNeedsNoFileRuns(String source, @TempDir Path folder) throws Exception {
        String name = compile(source, folder);
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                folder + File.pathSeparator + System.getProperty("java.class.path"), name).redirectErrorStream(true).start();
        assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip()).isEqualTo("480000 pixels");
    }

    private static String compile(String source, Path folder) {
        Matcher name = Pattern.compile("(?m)^class (\\w+)").matcher(source);
        assertThat(name.find()).isTrue();
        DiagnosticCollector<JavaFileObject> complaints = new DiagnosticCollector<>();
        JavaFileObject file = new SimpleJavaFileObject(URI.create("string:///" + name.group(1) + ".java"), JavaFileObject.Kind.SOURCE) {
            @Override
            public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                return source;
            }
        };
        boolean compiled = ToolProvider.getSystemJavaCompiler().getTask(null, null, complaints,
                List.of("-d", folder.toString(), "-proc:none"), null, List.of(file)).call();
        assertThat(compiled).as(complaints.getDiagnostics().toString()).isTrue();
        return name.group(1);
    }

    @ParameterizedTest
    @MethodSource("sceneExamples")
    void everySceneIsValid(String xml) throws Exception {
        assertThat(SceneFiles.parse(xml).objects()).isNotEmpty();
    }

    /** What the page of elements shows stands in the scene above it, as the site renders it; whatever the schema knows is shown. */
    @Test
    void everyElementIsShownAndValid() throws Exception {
        String page = Files.readString(Path.of("../docs/elements.md"));
        List<String> shown = Pattern.compile("```xml\n(.*?)```", Pattern.DOTALL).matcher(page).results().map(result -> result.group(1)).toList();
        assertThat(shown).hasSizeGreaterThan(70);
        String stage = "";
        for (String example : shown) {
            if (example.contains(STAGE)) {
                stage = example;
                continue;
            }
            String scene = stage.replace(STAGE, example);
            assertThat(SceneFiles.contents(new ByteArrayInputStream(scene.getBytes(StandardCharsets.UTF_8)), example, Map.of(), Assets.beside(Path.of("../scenes/example.xml"))).scenes()).hasSize(1);
        }
        List<String> known = Pattern.compile("<(?:xs:)?element name=\"([\\w-]+)\"").matcher(SceneFiles.schema()).results().map(one -> one.group(1)).distinct()
                .filter(name -> !name.matches("database|description")).toList();
        assertThat(known).hasSizeGreaterThan(50).allSatisfy(name -> assertThat(page).containsPattern("<" + name + "[ >/]"));
    }

    @Test
    void theGalleryShowsThirtyScenesThatAreThere() throws IOException {
        List<String> names = Pattern.compile("\\]\\(gallery/([\\w-]+)\\.jpg\\)").matcher(Files.readString(Path.of("../docs/gallery.md"))).results().map(result -> result.group(1)).toList();
        assertThat(names).hasSize(30).doesNotHaveDuplicates().allSatisfy(name -> {
            assertThat(Path.of("../scenes", name + ".xml")).exists();
            assertThat(Files.size(Path.of("../docs/gallery", name + ".jpg"))).isLessThan(40_000);
        });
    }

    /** What a newcomer sees first: smooth edges, a soft shadow and a blurred background, in four lines. */
    @Test
    void theFirstSceneTakesFourLines() throws Exception {
        String xml = sceneExamples().findFirst().orElseThrow();
        assertThat(xml.lines().toList()).as("with the element around it").hasSize(6);
        Scene scene = SceneFiles.parse(xml);
        assertThat(scene.settings().isAdaptive()).isTrue();
        assertThat(scene.camera().lens()).isInstanceOfSatisfying(Lens.Perspective.class, lens -> assertThat(lens.aperture()).isPositive());
        assertThat(scene.lights()).allMatch(light -> light instanceof SphereLight);
        Image image = Renderer.render(scene.withSettings(scene.settings().withSize(80, 60)));
        assertThat(Arrays.stream(image.toArgb()).distinct().count()).as("different colours").isGreaterThan(200);
    }

    @Test
    void everyShippedSceneIsMentioned() throws IOException {
        String readme = String.join("\n", pages().values());
        try (Stream<Path> files = Files.list(Path.of("../scenes"))) {
            assertThat(files.map(file -> file.getFileName().toString())).allSatisfy(name -> assertThat(readme).contains(name));
        }
    }

    /** A newcomer reads it to the end, and comes from it wherever it points: files that are there, and headings in them. */
    @Test
    void theReadmeIsShortAndAllLinksLeadSomewhere() throws IOException {
        Map<Path, String> pages = pages();
        for (String beside : List.of("CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md")) {
            pages.put(Path.of("../" + beside), Files.readString(Path.of("../" + beside)));
        }
        pages.putAll(pages("../docs/decisions"));
        assertThat(Files.readAllLines(README)).hasSizeLessThanOrEqualTo(130);
        assertThat(Files.readString(README)).as("every page is found from it")
                .contains(pages().keySet().stream().skip(1).map(page -> "(" + Path.of("..").relativize(page).toString().replace('\\', '/') + ")").toList());
        List<String> lost = new ArrayList<>();
        pages.forEach((page, text) -> Pattern.compile("\\]\\(([^)#\\s]*)(#[^)\\s]+)?\\)").matcher(text).results().filter(link -> !link.group(1).startsWith("http")).forEach(link -> {
            Path target = link.group(1).isEmpty() ? page : page.resolveSibling(link.group(1)).normalize();
            if (!Files.exists(target) || (link.group(2) != null && !headings(pages.getOrDefault(target, "")).contains(link.group(2)))) {
                lost.add(page + ": " + link.group());
            }
        }));
        assertThat(lost).isEmpty();
    }

    @Test
    void theSiteLeadsToEveryPage() throws IOException {
        String site = Files.readString(Path.of("../docs/site/site.xml"));
        assertThat(site).contains(pages().keySet().stream().skip(1).map(page -> "href=\"" + Path.of("..").relativize(page).toString().replace('\\', '/').replaceFirst("md$", "html") + "\"").toList());
    }

    /** A decision is a file, and stands on their page once, by the heading that it has. */
    @Test
    void everyDecisionIsAFileThatIsListed() throws IOException {
        List<String> listed = Pattern.compile("(?m)^- \\[(.+)\\]\\((decisions/[a-z0-9-]+\\.md)\\): .+$").matcher(Files.readString(Path.of("../docs/decisions.md"))).results()
                .map(line -> line.group(2) + " # " + line.group(1)).toList();
        List<String> files = pages("../docs/decisions").entrySet().stream().map(page -> "decisions/" + page.getKey().getFileName() + " " + page.getValue().lines().findFirst().orElse("")).toList();
        assertThat(listed).hasSizeGreaterThan(50).containsExactlyInAnyOrderElementsOf(files);
        assertThat(pages("../docs/decisions")).allSatisfy((page, text) -> assertThat(text.lines().skip(1).filter(line -> !line.isBlank() && !line.startsWith("#"))).as("%s says more", page).isNotEmpty());
    }

    /** Who follows CONTRIBUTING.md finds the files where it says. */
    @Test
    void theFilesThatContributorsAreSentToAreThere() throws IOException {
        List<String> named = Pattern.compile("`(\\w+(?:/\\w+)*/\\w+\\.(?:java|properties))`").matcher(Files.readString(Path.of("../CONTRIBUTING.md"))).results().map(file -> file.group(1)).toList();
        assertThat(named).hasSizeGreaterThan(8).allSatisfy(name -> assertThat(Stream.of("src/main/java", "src/main/resources", "src/test/java")
                .map(root -> Path.of(root, "cz/paprsek", name))).as(name).anyMatch(Files::exists));
    }

    /** As links name them: small letters and hyphens. */
    private static List<String> headings(String page) {
        return Pattern.compile("(?m)^#+ (.*)$").matcher(page).results()
                .map(heading -> "#" + heading.group(1).toLowerCase(Locale.ROOT).replaceAll("(?U)[^\\w\\- ]", "").replace(' ', '-')).toList();
    }
}
