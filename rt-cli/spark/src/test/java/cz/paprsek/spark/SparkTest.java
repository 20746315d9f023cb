package cz.paprsek.spark;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Embedded;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.io.TempDir;

/**
 * Films rendered by a real cluster of Spark's on this machine, {@code local-cluster}, whose executors are processes of their own and are killed. Only where the environment says where a distribution of Spark
 * 4.0 is: {@code SPARK_HOME}.
 */
@EnabledIfEnvironmentVariable(named = "SPARK_HOME", matches = ".+")
class SparkTest {
    private static final String EXECUTOR = "CoarseGrainedExecutorBackend";
    private static final int MOST_SECONDS = 300;
    private static final int KILLS = Integer.getInteger("paprsek.kills", 5);

    @TempDir
    Path folder;

    private Path jar;
    private Path scene;

    /** A film of a scene that includes another one and names a picture, in another folder than the process works in. */
    @BeforeEach
    void jarAndSceneAreThere() throws IOException {
        jar = jar(folder.resolve("rt-spark.jar"));
        Path parts = Files.createDirectories(folder.resolve("scene/parts"));
        Files.copy(Path.of("../../scenes/pictures/globe.png"), parts.resolve("globe.png"));
        Files.writeString(parts.resolve("ball.xml"), """
                <scene xmlns="urn:paprsek:scene:1"><camera position="0 0 5" target="0 0 0" fovy="40"/>
                <define name="ball"><sphere radius="1" position="0 0 0"/></define></scene>""");
        scene = Files.writeString(folder.resolve("scene/film.xml"), """
                <scene xmlns="urn:paprsek:scene:1" name="Film"><render width="192" height="192" samples="4"/><camera position="0 1 6" target="0 0 0" fovy="40"/>
                <sun-light direction="-1 -2 -1.2" angle="3"/><include file="parts/ball.xml"/>
                <instance of="ball" name="one" position="0 0 0"><material reflection="0.3"><image file="parts/globe.png"/></material></instance>
                <plane position="0 -1 0"><material reflection="0.2"><checker size="1" even="250 250 250" odd="60 60 60"/></material></plane>
                <animate target="one" attribute="position"><key t="0" value="-1 0 0"/><key t="0.3" value="1 0.5 0"/></animate></scene>""");
    }

    @Test
    void executorsKilledAgainAndAgainMakeTheSameFilm() throws Exception {
        Map<String, String> whole = whole("--frames", "1-4");
        Random random = new Random(7);
        Process driver = started("--frames", "1-4", "--side", "32", "-o", folder.resolve("out").toUri() + "/film.png");
        Set<Long> killed = new HashSet<>();
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(MOST_SECONDS);
        while (!driver.waitFor(1000 + random.nextInt(2000), TimeUnit.MILLISECONDS)) {
            assertThat(System.nanoTime()).as("patience").isLessThan(end);
            List<ProcessHandle> executors = driver.descendants().filter(SparkTest::isExecutor).toList();
            // Not before they are at work.
            if (!executors.isEmpty() && killed.size() < KILLS && parts() > 0) {
                ProcessHandle victim = executors.get(random.nextInt(executors.size()));
                if (victim.destroyForcibly()) {
                    killed.add(victim.pid());
                }
            }
        }
        String log = Files.readString(folder.resolve("log"));
        assertThat(driver.exitValue()).as(log).isZero();
        assertThat(killed).as("executors killed").hasSizeGreaterThan(1);
        assertThat(log).contains("ExecutorLostFailure");
        assertThat(digests(folder.resolve("out"))).isEqualTo(whole);
    }

    @Test
    void framesOfLongFilmsAreTasks() throws Exception {
        Map<String, String> whole = whole("--frames", "1-16", "--size", "64x48", "--bits", "16");
        Process driver = started("--frames", "1-16", "--size", "64x48", "--bits", "16", "-o", folder.resolve("out").toUri() + "/film.png");
        assertThat(driver.waitFor(MOST_SECONDS, TimeUnit.SECONDS)).isTrue();
        assertThat(driver.exitValue()).isZero();
        assertThat(Files.readString(folder.resolve("log"))).contains("16 pictures, 16 tiles of 512x512 pixels rendered");
        assertThat(digests(folder.resolve("out"))).isEqualTo(whole);
    }

    @Test
    void wrongScenesAreTold() throws Exception {
        Files.writeString(scene, "<scene xmlns=\"urn:paprsek:scene:1\"><sphere radius=\"x\"/></scene>");
        Process driver = started("-o", folder.resolve("out").toUri() + "/film.png");
        assertThat(driver.waitFor(MOST_SECONDS, TimeUnit.SECONDS)).isTrue();
        assertThat(Files.readString(folder.resolve("log"))).contains(scene + ":1:");
        assertThat(driver.exitValue()).isEqualTo(3);
    }

    /** What one process makes. */
    private Map<String, String> whole(String... words) throws Exception {
        List<String> all = new ArrayList<>(List.of("render", scene.toString(), "--quiet", "-o", folder.resolve("whole/film.png").toString()));
        all.addAll(List.of(words));
        assertThat(Embedded.run(OutputStream.nullOutputStream(), new PrintWriter(System.err, true, StandardCharsets.UTF_8), all)).isZero();
        return digests(folder.resolve("whole"));
    }

    private Process started(String... words) throws IOException {
        String spark = System.getenv("SPARK_HOME");
        List<String> all = new ArrayList<>(List.of("bash", Path.of(spark, "bin", "spark-submit").toString(), "--master", "local-cluster[2,1,1024]", "--conf", "spark.task.maxFailures=50", "--conf",
                "spark.deploy.maxExecutorRetries=-1", "--conf", "spark.ui.enabled=false", "--class", SparkRender.class.getName(), jar.toString(), scene.toString()));
        all.addAll(List.of(words));
        ProcessBuilder builder = new ProcessBuilder(all).directory(folder.toFile()).redirectErrorStream(true).redirectOutput(folder.resolve("log").toFile());
        builder.environment().put("SPARK_LOCAL_IP", "127.0.0.1");
        builder.environment().put("SPARK_WORKER_DIR", folder.resolve("work").toString());
        return builder.start();
    }

    private static boolean isExecutor(ProcessHandle process) {
        // With long command lines, Java knows only the arguments of its own.
        try {
            return Files.readString(Path.of("/proc", String.valueOf(process.pid()), "cmdline"), StandardCharsets.ISO_8859_1).contains(EXECUTOR);
        } catch (IOException gone) {
            return false;
        }
    }

    private long parts() throws IOException {
        if (!Files.exists(folder.resolve("out"))) {
            return 0;
        }
        try (Stream<Path> files = Files.find(folder.resolve("out"), 3, (file, attributes) -> file.toString().endsWith(".part"))) {
            return files.count();
        } catch (UncheckedIOException goneMeanwhile) {
            return 0;
        }
    }

    /** Of all files in a folder, by name: what was under way must have gone. */
    private static Map<String, String> digests(Path folder) throws Exception {
        Map<String, String> digests = new TreeMap<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                digests.put(file.getFileName().toString(), HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file))));
            }
        }
        return digests;
    }

    /** All of ours and picocli, as the profile packs them; the rest of the class path is the cluster's own, or for tests. */
    private static Path jar(Path file) throws IOException {
        Set<String> names = new HashSet<>();
        try (OutputStream out = Files.newOutputStream(file); JarOutputStream jar = new JarOutputStream(out)) {
            for (String entry : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
                Path place = Path.of(entry);
                if (Files.isDirectory(place) && !place.endsWith("test-classes")) {
                    try (Stream<Path> files = Files.walk(place)) {
                        for (Path each : files.filter(Files::isRegularFile).toList()) {
                            add(jar, names, place.relativize(each).toString().replace('\\', '/'), Files.readAllBytes(each));
                        }
                    }
                } else if (entry.matches(".*/(picocli|jspecify|jakarta.xml.bind-api|rt-core|rt-cli)[^/]*\\.jar")) {
                    try (JarFile packed = new JarFile(entry)) {
                        for (JarEntry each : packed.stream().filter(one -> !one.isDirectory()).toList()) {
                            add(jar, names, each.getName(), packed.getInputStream(each).readAllBytes());
                        }
                    }
                }
            }
        }
        return file;
    }

    private static void add(JarOutputStream jar, Set<String> names, String name, byte[] content) throws IOException {
        if (!name.endsWith("module-info.class") && !name.equals("META-INF/MANIFEST.MF") && names.add(name)) {
            jar.putNextEntry(new JarEntry(name));
            jar.write(content);
            jar.closeEntry();
        }
    }
}
