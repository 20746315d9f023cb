package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The script that starts the program, with a Java that only writes down what it was asked for. */
@DisabledOnOs(OS.WINDOWS)
@Timeout(60)
class LauncherTest {
    private static final String JAVA = """
            #!/bin/sh
            for word; do
                case $word in -XX:ArchiveClassesAtExit=*) echo "training begins" >> "$LOG"; : > "${word#*=}"; touch "${4}.png"; exit 0 ;; esac
            done
            echo "call $*" >> "$LOG"
            sleep 1
            echo "call ends" >> "$LOG"
            exit 7
            """;

    @TempDir
    Path folder;
    private Path cache;
    private Path log;

    @BeforeEach
    void install() throws IOException {
        Path home = Files.createDirectories(folder.resolve("jdk"));
        Files.createDirectory(home.resolve("bin"));
        Files.writeString(home.resolve("release"), "JAVA_VERSION=\"17.0.9\"\n");
        executable(home.resolve("bin/java"), JAVA);
        executable(folder.resolve("paprsek"), Files.readString(Path.of("src/main/launcher/paprsek")));
        Files.createFile(folder.resolve("rt-cli.jar"));
        cache = folder.resolve("cache/paprsek");
        log = folder.resolve("log");
    }

    private static void executable(Path file, String text) throws IOException {
        Files.writeString(file, text);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private int call(String... words) throws Exception {
        return call(folder.resolve("jdk"), words);
    }

    private int call(Path home, String... words) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(folder.resolve("paprsek").toString()).redirectErrorStream(true);
        builder.command().addAll(List.of(words));
        builder.environment().put("JAVA_HOME", home.toString());
        builder.environment().put("XDG_CACHE_HOME", folder.resolve("cache").toString());
        builder.environment().put("LOG", log.toString());
        Process process = builder.start();
        assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)).isEmpty();
        assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
        return process.exitValue();
    }

    /** The program in a jar, which archives want, and not folders; the libraries are where they are. */
    private static void jar(Path jar) throws IOException {
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
        jar(folder.resolve("rt-cli.jar"));
        assertThat(call(Path.of(System.getProperty("java.home")), "render", Scenes.ball(folder.resolve("s.xml")).toString(), "-q", "-o", folder.resolve("p.png").toString()))
                .isZero();
        while (!Files.isDirectory(cache) || Files.exists(cache.resolve("lock")) || cache.toFile().list().length == 0) {
            Thread.sleep(100);
        }
        assertThat(cache.toFile().list()).hasSize(1).allMatch(name -> name.endsWith(".archive"));
        assertThat(call(Path.of(System.getProperty("java.home")), "schema", "-o", folder.resolve("x").toString())).isZero();
    }

    @Test
    @Timeout(180)
    void largeScenesAreRenderedWithVectorsAndNobodyHearsOfIt() throws Exception {
        jar(folder.resolve("rt-cli.jar"));
        Path home = Path.of(System.getProperty("java.home"));
        assumeTrue(Files.readString(home.resolve("release")).contains("jdk.incubator.vector"));
        Path large = Files.writeString(folder.resolve("large.xml"), "<scene xmlns='urn:paprsek:scene:1'>" + " ".repeat(1_100_000) + "<cube/></scene>");
        assertThat(said(3, "validate", large.toString())).contains("cube").doesNotContain("incubator");
        assertThat(said(0, "bench", "--scene", "few", "--size", "8x8", "--rounds", "1")).contains("vectors of 8 floats").doesNotContain("incubator");
        assertThat(said(0, "--version")).contains("scalar");
    }

    /** What is said by this Java, without an archive. */
    private String said(int code, String... words) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(folder.resolve("paprsek").toString()).redirectErrorStream(true);
        builder.command().addAll(List.of(words));
        builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
        builder.environment().put("XDG_CACHE_HOME", "/nonexistent");
        Process process = builder.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).isEqualTo(code);
        return said;
    }

    private void waitForTraining() throws InterruptedException {
        while (!Files.exists(cache.resolve("java-17.0.9.archive")) || Files.exists(cache.resolve("lock"))) {
            Thread.sleep(50);
        }
    }

    @Test
    void theArchiveIsMadeWhenTheFirstCallIsOverAndNothingElseStaysBehind() throws Exception {
        assertThat(call("render", "a b.xml")).isEqualTo(7);
        waitForTraining();
        assertThat(Files.readAllLines(log)).containsExactly(
                "call -XX:MaxGCPauseMillis=50 -jar " + folder.resolve("rt-cli.jar") + " render a b.xml", "call ends", "training begins");
        assertThat(cache.toFile().list()).containsExactly("java-17.0.9.archive");
        call("info");
        assertThat(Files.readString(log)).contains("call -XX:SharedArchiveFile=" + cache.resolve("java-17.0.9.archive")).containsOnlyOnce("training");
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
        waitForTraining();
        assertThat(cache.toFile().list()).containsExactly("java-17.0.9.archive");
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
