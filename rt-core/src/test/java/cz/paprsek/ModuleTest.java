package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.attribute.Element;
import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.lang.module.ModuleDescriptor.Exports;
import java.lang.module.ModuleFinder;
import java.lang.reflect.Executable;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.jspecify.annotations.NullMarked;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The library as a module, which the programs here and all other tests do not use: they run from the class path. */
@Timeout(120)
class ModuleTest {
    private static final Path SOURCES = Path.of("src/main/java");
    /** What is on offer to everybody is to be learnt and kept for long. What is a word of scene files, such as a shape, does not count: who knows the word knows it. */
    private static final int MOST_PUBLIC_TYPES = 71;

    @TempDir
    private static Path folder;

    private static Path core;

    /** What came of a program. */
    private record Run(int code, String said) {}

    @BeforeAll
    static void makeTheModule() throws IOException {
        core = folder.resolve("core");
        Path classes = Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator)).map(Path::of)
                .filter(entry -> Files.exists(entry.resolve("cz/paprsek/render/Renderer.class"))).findFirst().orElseThrow();
        try (Stream<Path> all = Files.walk(classes)) {
            for (Path file : all.filter(Files::isRegularFile).toList()) {
                Path copy = core.resolve(classes.relativize(file).toString());
                Files.createDirectories(copy.getParent());
                Files.copy(file, copy);
            }
        }
        Run compiled = compile(core, "-p", libraries(), "--patch-module", "cz.paprsek.core=" + core, SOURCES.resolve("module-info.java").toString());
        assertThat(compiled.code()).as(compiled.said()).isZero();
    }

    @Test
    void whoOnlyRendersNeedsNeitherJaxbNorAwt() throws Exception {
        Path user = user("""
                import cz.paprsek.image.ImageFiles;
                import cz.paprsek.image.ImageFormat;
                import cz.paprsek.render.Renderer;
                import cz.paprsek.scene.Scene;
                import cz.paprsek.scene.SceneObject;
                import cz.paprsek.shape.Sphere;
                import cz.paprsek.xml.SceneFiles;
                import java.nio.file.Path;
                """, """
                var image = Renderer.render(Scene.EMPTY.plus(SceneObject.of(new Sphere(1))));
                int objects = SceneFiles.read(Path.of(words[0])).objects().size();
                var bytes = new java.io.ByteArrayOutputStream();
                ImageFiles.write(image, bytes, ImageFormat.PPM);
                System.out.println((objects > 5) + ", " + image.toArgb().length + " pixels, " + bytes.size() + " bytes, "
                        + ModuleLayer.boot().findModule("java.desktop").isPresent() + ModuleLayer.boot().findModule("jakarta.xml.bind").isPresent());
                """);
        Run run = java("--limit-modules", "java.xml,cz.paprsek.core,user", "-p", path(core, user), "-m", "user/user.Main", "../scenes/showcase.xml");
        assertThat(run.said()).isEqualTo("true, 480000 pixels, 1440015 bytes, falsefalse");
    }

    @Test
    void aModuleReadsScenesAndTheirProblemsAndWritesPictures() throws Exception {
        Path good = Path.of("../scenes/showcase.xml").toAbsolutePath();
        Path bad = Files.writeString(folder.resolve("bad.xml"), "<scene xmlns=\"urn:paprsek:scene:1\">\n  <sphere raduis=\"1\"/>\n</scene>");
        Path user = user("""
                import cz.paprsek.image.ImageFiles;
                import cz.paprsek.render.Renderer;
                import cz.paprsek.xml.SceneFileException;
                import cz.paprsek.xml.SceneFiles;
                import java.nio.file.Path;
                """, """
                var scene = SceneFiles.read(Path.of(words[0]));
                ImageFiles.write(Renderer.render(scene.withSettings(scene.settings().withSize(64, 36))), Path.of(words[2]));
                try {
                    SceneFiles.read(Path.of(words[1]));
                } catch (SceneFileException e) {
                    e.problems().forEach(System.out::println);
                }
                """);
        Path picture = folder.resolve("picture.png");
        Run run = java("-p", path(core, user) + File.pathSeparator + libraries(), "--add-modules", "jakarta.xml.bind,org.glassfish.jaxb.runtime",
                "-m", "user/user.Main", good.toString(), bad.toString(), picture.toString());
        assertThat(run.said()).contains(bad + ":2:").contains("did you mean \"radius\"?").doesNotContain("Exception");
        assertThat(Files.readAllBytes(picture)).startsWith(0x89, 'P', 'N', 'G');
    }

    @Test
    void whatIsNotOnOfferIsNotSeen() throws Exception {
        Path source = source("import cz.paprsek.io.AtomicFile;", "System.out.println(AtomicFile.class);");
        Run compiled = compile(folder.resolve("refused"), "-p", core.toString(), source.toString(), source.resolveSibling("module-info.java").toString());
        assertThat(compiled.code()).isNotZero();
        assertThat(compiled.said()).contains("package cz.paprsek.io is not visible");
    }

    @Test
    void whatIsOnOfferToEverybodyIsNotTooMuch() throws Exception {
        List<String> offered = new ArrayList<>();
        for (Exports exports : ModuleFinder.of(core).find("cz.paprsek.core").orElseThrow().descriptor().exports()) {
            if (!exports.isQualified()) {
                offered.addAll(publicTypes(exports.source()));
            }
        }
        offered.removeIf(ModuleTest::isWord);
        assertThat(offered).as("public types in packages exported to all").hasSizeBetween(50, MOST_PUBLIC_TYPES);
    }

    /** Nobody could write down what such a method takes or gives; but that a shape is placed is between it and the renderer. */
    @Test
    void whatIsOnOfferNamesNothingThatIsNot() throws Exception {
        Set<String> open = ModuleFinder.of(core).find("cz.paprsek.core").orElseThrow().descriptor().exports().stream()
                .filter(exports -> !exports.isQualified()).map(Exports::source).collect(Collectors.toSet());
        List<String> hidden = new ArrayList<>();
        for (String room : open) {
            for (String name : publicTypes(room)) {
                Class<?> type = Class.forName(name);
                for (Executable way : (Iterable<Executable>) Stream.<Executable>concat(Arrays.stream(type.getConstructors()), Arrays.stream(type.getMethods()))
                        .filter(one -> !one.getName().equals("place"))::iterator) {
                    Stream.concat(Arrays.stream(way.getParameterTypes()), way instanceof Method method ? Stream.of(method.getReturnType()) : Stream.empty())
                            .filter(named -> named.getPackageName().startsWith("cz.paprsek") && !open.contains(named.getPackageName()))
                            .forEach(named -> hidden.add(way + " names " + named));
                }
            }
        }
        assertThat(hidden).isEmpty();
    }

    /** Checkers and other languages then know that what a signature does not call nullable is not: also from the class path, where the module's word does not count. */
    @Test
    void whatIsOnOfferIsSaidToBeWithoutNulls() {
        assertThat(ModuleFinder.of(core).find("cz.paprsek.core").orElseThrow().descriptor().exports().stream().filter(exports -> !exports.isQualified()).map(Exports::source))
                .isNotEmpty().allSatisfy(room -> assertThat(Class.forName(room + ".package-info").isAnnotationPresent(NullMarked.class)).as(room).isTrue());
    }

    @Test
    void aModuleKeepsTilesAndThreads() throws Exception {
        Path user = user("""
                import cz.paprsek.render.RenderMonitor;
                import cz.paprsek.render.RenderOptions;
                import cz.paprsek.render.RenderScene;
                import cz.paprsek.render.Renderer;
                import cz.paprsek.render.Tile;
                import cz.paprsek.render.TileStore;
                import cz.paprsek.render.film.Film;
                import cz.paprsek.scene.RenderSettings;
                import cz.paprsek.scene.Scene;
                import java.util.concurrent.atomic.AtomicInteger;
                """, """
                var kept = new AtomicInteger();
                TileStore store = new TileStore() {
                    @Override
                    public boolean load(Tile tile, int pass, Film into) {
                        into.set(tile.x(), tile.y(), 1, 0.5, 0.25);
                        return tile.x() == 0 && tile.y() == 0;
                    }

                    @Override
                    public void save(Tile tile, int pass, Film from) {
                        kept.incrementAndGet();
                    }
                };
                var options = RenderOptions.of(RenderSettings.DEFAULT.withSize(101, 67));
                var image = Renderer.render(Scene.EMPTY, options, RenderMonitor.NONE, store).image();
                System.out.print(kept + " tiles, " + image.green(0, 0) + ";");
                try (Renderer renderer = Renderer.keeping("mine")) {
                    for (int step : new int[] {8, 1}) {
                        var coarse = renderer.next(RenderScene.of(Scene.EMPTY), options.withStep(step), RenderMonitor.NONE).image();
                        System.out.print(" " + coarse.width() + " x " + coarse.height());
                    }
                }
                """);
        Run run = java("-p", path(core, user), "-m", "user/user.Main");
        assertThat(run.said()).isEqualTo("11 tiles, 0.5; 13 x 9 101 x 67");
    }

    private static boolean isWord(String type) {
        try {
            return Class.forName(type).isAnnotationPresent(Element.class);
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    private static List<String> publicTypes(String name) throws IOException, ClassNotFoundException {
        List<String> found = new ArrayList<>();
        try (Stream<Path> files = Files.list(SOURCES.resolve(name.replace('.', '/')))) {
            for (Path file : files.filter(path -> path.toString().endsWith(".java") && !path.endsWith("package-info.java")).sorted().toList()) {
                Class<?> type = Class.forName(name + "." + String.valueOf(file.getFileName()).replace(".java", ""));
                if (Modifier.isPublic(type.getModifiers())) {
                    found.add(type.getName());
                }
            }
        }
        return found;
    }

    /** Compiles a module with one program. */
    private static Path user(String imports, String body) throws IOException {
        Path source = source(imports, body);
        Path classes = source.resolveSibling("classes");
        Run compiled = compile(classes, "-p", core.toString(), source.toString(), source.resolveSibling("module-info.java").toString());
        assertThat(compiled.code()).as(compiled.said()).isZero();
        return classes;
    }

    private static Path source(String imports, String body) throws IOException {
        Path directory = Files.createTempDirectory(folder, "user");
        Files.writeString(directory.resolve("module-info.java"), "module user { requires cz.paprsek.core; }");
        return Files.writeString(directory.resolve("Main.java"), "package user;\n" + imports
                + "class Main {\n    public static void main(String[] words) throws Exception {\n" + body + "    }\n}\n");
    }

    private static Run compile(Path into, String... words) {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter said = new StringWriter();
        List<String> options = new ArrayList<>(List.of("--release", "17", "-proc:none", "-d", into.toString()));
        List<Path> sources = new ArrayList<>();
        for (String word : words) {
            if (word.endsWith(".java")) {
                sources.add(Path.of(word));
            } else {
                options.add(word);
            }
        }
        var files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8);
        boolean isDone = compiler.getTask(said, files, null, options, null, files.getJavaFileObjectsFromPaths(sources)).call();
        return new Run(isDone ? 0 : 1, said.toString());
    }

    private static Run java(String... words) throws Exception {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xmx512m"));
        command.addAll(List.of(words));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
        return new Run(process.waitFor(), said);
    }

    private static String path(Path... entries) {
        return Arrays.stream(entries).map(Path::toString).collect(Collectors.joining(File.pathSeparator));
    }

    /** JAXB and what it needs, of all that the tests have. */
    private static String libraries() {
        return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator)).sorted(Comparator.reverseOrder())
                .filter(entry -> entry.matches(".*/(jakarta|jaxb|angus|istack|txw2|jspecify)[^/]*\\.jar"))
                .collect(Collectors.joining(File.pathSeparator));
    }
}
