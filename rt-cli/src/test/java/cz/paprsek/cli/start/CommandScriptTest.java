package cz.paprsek.cli.start;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.cli.Main;
import cz.paprsek.cli.Scenes;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The command line's: the archive is made in the background, by a second call of Java. */
class CommandScriptTest extends StartScript {
    private static final String JAVA = """
            #!/bin/sh
            for word; do
                case $word in -XX:ArchiveClassesAtExit=*) echo "training begins $1 $word" >> "$LOG"; : > "${word#*=}"; touch "$8.png"; exit 0 ;; esac
            done
            echo "call $*" >> "$LOG"
            case " $* " in *" render a b.xml "*) sleep 1 ;; esac
            echo "call ends" >> "$LOG"
            exit 7
            """;

    CommandScriptTest() {
        super(Path.of("src/main/launcher/paprsek"), "rt-cli.jar", JAVA);
    }

    @Override
    String run(Path installation) throws Exception {
        Files.deleteIfExists(log);
        assertThat(call(installation, Map.of())).isEqualTo(new Answer(7, ""));
        String calls = Files.readString(log);
        return calls.contains("-XX:SharedArchiveFile=") || !Files.isDirectory(cache) ? calls : calls + trained();
    }

    /** What is written down when the archive has been made. */
    private String trained() throws Exception {
        while (!Files.readString(log).contains("training") || Files.exists(cache.resolve("lock"))) {
            Thread.sleep(20);
        }
        return Files.readString(log);
    }

    private int call(String... words) throws Exception {
        return call(home, words);
    }

    private int call(Path java, String... words) throws Exception {
        Answer answer = call(folder, Map.of("JAVA_HOME", java.toString()), words);
        assertThat(answer.said()).isEmpty();
        return answer.code();
    }

    /** The program in a jar, which archives want, and not folders; the libraries are where they are. */
    private static void pack(Path jar) throws IOException {
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.MAIN_CLASS, Main.class.getName());
        List<Path> path = Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator)).map(Path::of).filter(Files::exists).toList();
        manifest.getMainAttributes().put(Attributes.Name.CLASS_PATH, path.stream().filter(Files::isRegularFile)
                .map(file -> file.toUri().toString()).collect(Collectors.joining(" ")));
        Set<String> names = new HashSet<>();
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar), manifest)) {
            for (Path root : path.stream().filter(Files::isDirectory).toList()) {
                try (Stream<Path> files = Files.walk(root)) {
                    for (Path file : files.filter(Files::isRegularFile).filter(file -> file.toString().contains("paprsek")).toList()) {
                        if (names.add(root.relativize(file).toString())) {
                            out.putNextEntry(new JarEntry(root.relativize(file).toString()));
                            Files.copy(file, out);
                        }
                    }
                }
            }
        }
    }

    @Test
    @Timeout(180)
    void thisJavaCanArchiveTheProgram() throws Exception {
        pack(jar);
        assertThat(call(Path.of(System.getProperty("java.home")), "render", Scenes.ball(folder.resolve("s.xml")).toString(), "-q", "-o", folder.resolve("p.png").toString()))
                .isZero();
        while (!Files.isDirectory(cache) || archives().isEmpty()) {
            Thread.sleep(100);
        }
        assertThat(archives()).hasSize(1).allMatch(file -> file.toString().endsWith(".archive"));
        assertThat(call(Path.of(System.getProperty("java.home")), "schema", "-o", folder.resolve("x").toString())).isZero();
    }

    @Test
    @Timeout(180)
    void largeScenesAreRenderedWithVectorsAndNobodyHearsOfIt() throws Exception {
        pack(jar);
        Path home = Path.of(System.getProperty("java.home"));
        assumeTrue(Files.readString(home.resolve("release")).contains("jdk.incubator.vector"));
        Path large = Files.writeString(folder.resolve("large.xml"), "<scene xmlns='urn:paprsek:scene:1'>" + " ".repeat(1_100_000) + "<cube/></scene>");
        assertThat(said(3, "validate", large.toString())).contains("cube").doesNotContain("incubator");
        assertThat(said(0, "bench", "--scene", "few", "--size", "8x8", "--rounds", "1")).containsPattern("vectors of (8|16) floats").doesNotContain("incubator");
        assertThat(said(0, "--version")).contains("scalar");
    }

    /** What is said by this Java, without an archive. */
    private String said(int code, String... words) throws Exception {
        Answer answer = call(folder, Map.of("JAVA_HOME", System.getProperty("java.home"), "XDG_CACHE_HOME", inTheWay()), words);
        assertThat(answer.code()).isEqualTo(code);
        return answer.said();
    }

    /** A cache in which no archive can be made: nothing is left to do when the call is over. */
    private String inTheWay() throws IOException {
        return Files.writeString(folder.resolve("in the way"), "").toString();
    }

    private int callAlone(String... words) throws Exception {
        Answer answer = call(folder, Map.of("XDG_CACHE_HOME", inTheWay()), words);
        assertThat(answer.said()).isEmpty();
        return answer.code();
    }

    private Path onlyArchive() throws Exception {
        assertThat(archives()).hasSize(1);
        assertThat(archives().get(0).getFileName().toString()).matches("rt-cli-17\\.0\\.9-\\d+-\\d+[A-Z][a-z]{2}\\d+\\.archive");
        return archives().get(0);
    }

    /** Interpreted: what waits for Java 17's compiler when it ends is archived as waiting, and never compiled. */
    @Test
    void theArchiveIsMadeWhenTheFirstCallIsOverAndNothingElseStaysBehind() throws Exception {
        assertThat(call("render", "a b.xml")).isEqualTo(7);
        trained();
        assertThat(Files.readAllLines(log)).containsExactly("call -XX:MaxGCPauseMillis=50 -jar " + jar + " render a b.xml", "call ends",
                "training begins -Xint -XX:ArchiveClassesAtExit=" + cache.resolve("lock/new"));
        Path archive = onlyArchive();
        call("info");
        assertThat(Files.readString(log)).contains("call -XX:SharedArchiveFile=" + archive).containsOnlyOnce("training");
    }

    /** Compiling well takes longer than it saves for one ray in each of a million pixels. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\u0000', nullValues = "-", value = {
            "true  | <sphere/>                                             | -o p.png -q",
            "true  | <sphere/>                                             | --size 1000x1000 --threads 1",
            "false | <sphere/>                                             | --size=1001x1000",
            "false | <sphere/>                                             | --samples 2",
            "false | <sphere/>                                             | --mode nodes",
            "false | <sphere/>                                             | --size 1e3x9",
            "true  | <render width=\"1280\" height=\"720\"/><sphere/>        | -q",
            "false | <render height=\"1280\" width=\"820\"/><sphere/>        | -q",
            "false | <camera/><render~ height=\"1280\"~ width=\"820\"~/> | -q",
            "true  | <camera/><render~ height=\"720\"~ width=\"1280\"/>~  | -q",
            "true  | <render height=\"1280\" width=\"820\"/><sphere/>        | --size 9x9",
            "true  | <render samples=\"1\"/><sphere/>                       | -q",
            "false | <render samples=\"16\"/><sphere/>                      | -q",
            "false | <render samples=\"1..4\"/><sphere/>                    | -q",
            "false | <render samples=\"{n}\"/><sphere/>                     | -q",
            "false | <render integrator=\"path\"/><sphere/>                 | -q",
            "false | <mesh file=\"m.stl\"/>                                 | -q",
            "false | <database><scene name=\"a\"/></database>              | -q",
            "false | <mesh\tfile=\"m.stl\"/>                               | -q",
            "false | <render samples='16'/><sphere/>                      | -q",
            "false | <render width = \"2000\"/><sphere/>                  | -q",
            "false | <repeat count=\"9\"><sphere/></repeat>                 | -q",
            "false | <area-light position=\"1 2 3\"/><sphere/>              | -q"})
    void aShortCallIsCompiledQuickly(boolean isQuick, String content, String words) throws Exception {
        Path scene = Files.writeString(folder.resolve("s.xml"), "<scene xmlns='urn:paprsek:scene:1'>" + content.replace('~', '\n') + "</scene>");
        List<String> all = new ArrayList<>(List.of("render", scene.toString()));
        all.addAll(List.of(words.strip().split(" ")));
        assertThat(callAlone(all.toArray(String[]::new))).isEqualTo(7);
        assertThat(Files.readString(log).contains("call -XX:TieredStopAtLevel=1 -XX:MaxGCPauseMillis=50")).isEqualTo(isQuick);
        assertThat(callAlone("render", scene.toString(), folder.resolve("s.xml").toString())).isEqualTo(7);
        assertThat(Files.readAllLines(log)).last().asString().isEqualTo("call ends");
        assertThat(Files.readAllLines(log).get(Files.readAllLines(log).size() - 2)).as("two pictures").doesNotContain("TieredStopAtLevel");
    }

    /** Many bodies are placed sooner than methods are compiled well; what stands for more work is found behind them, too. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aLongFileIsLookedThrough(boolean isQuick) throws Exception {
        Path scene = Files.writeString(folder.resolve("s.xml"), "<scene xmlns='urn:paprsek:scene:1'>" + "<sphere/>\n".repeat(1_000_000) + (isQuick ? "" : "<mesh file='m.stl'/>") + "</scene>");
        assertThat(callAlone("render", scene.toString())).isEqualTo(7);
        assertThat(Files.readString(log).contains("-XX:TieredStopAtLevel=1")).isEqualTo(isQuick);
    }

    @Test
    void whatCannotBeReadOrSaidIsNoMatterOfTheScript() throws Exception {
        Path secret = Files.createFile(folder.resolve("secret.xml"), PosixFilePermissions.asFileAttribute(Set.of()));
        assertThat(call("info", secret.toString())).isEqualTo(7);
        assertThat(callClosed("2>&-", Map.of(), "bench")).isEqualTo(new Answer(7, ""));
        assertThat(Files.readString(log)).contains("jdk.incubator.vector");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "4194303999", "nonsense"})
    void aLockOfAProcessThatIsNoMoreHeals(String owner) throws Exception {
        Path lock = Files.createDirectories(cache.resolve("lock"));
        Files.writeString(lock.resolve("training.xml"), "half");
        if (!owner.isEmpty()) {
            Files.writeString(lock.resolve("owner"), owner + "\n");
        }
        call("info");
        trained();
        onlyArchive();
    }

    @Test
    void aLockOfALivingProcessIsRespected() throws Exception {
        Path lock = Files.createDirectories(cache.resolve("lock"));
        Files.writeString(lock.resolve("owner"), ProcessHandle.current().pid() + "\n");
        call("info");
        Thread.sleep(3000);
        assertThat(Files.readString(log)).doesNotContain("training");
        assertThat(cache.toFile().list()).containsExactly("lock");
    }

    /** No image is built here: that needs a program which is not everywhere. */
    @Test
    void whatTheContainerCopiesIsWhatTheBuildMakes() throws IOException {
        List<String> lines = Files.readAllLines(Path.of("Dockerfile"));
        List<String> copied = lines.stream().filter(line -> line.startsWith("COPY ")).map(line -> line.replaceAll("^COPY (--\\S+ )*(\\S+) .*$", "$2")).toList();
        String pom = Files.readString(Path.of("pom.xml"));
        assertThat(copied).containsExactly("paprsek", "rt-cli.jar").allSatisfy(name -> assertThat(Files.exists(Path.of("src/main/launcher", name))
                || pom.contains("<finalName>" + name.replace(".jar", "") + "</finalName>")).as(name).isTrue());
        assertThat(pom).contains("<directory>src/main/launcher</directory>");
        assertThat(lines).contains("USER 65532:65532", "ENTRYPOINT [\"paprsek\"]").anyMatch(line -> line.matches("FROM \\S+:\\d+-jre"));
    }
}
