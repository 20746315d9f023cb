package cz.paprsek.cli.start;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** A script that starts a program, with a Java that only writes down what it was asked for; and what holds for every such script. */
@DisabledOnOs(OS.WINDOWS)
@Timeout(60)
abstract class StartScript {
    private static final String MAKES = "-XX:ArchiveClassesAtExit=";
    private static final String USES = "-XX:SharedArchiveFile=";

    /** What a call came to. */
    record Answer(int code, String said) {}

    private final Path source;
    private final String jarName;
    private final String java;

    /** With blanks in the names of what is in it. */
    @TempDir
    Path folder;
    /** Where Java is. */
    Path home;
    Path jar;
    /** Where the archives are. */
    Path cache;
    /** What Java was asked for. */
    Path log;

    /**
     * A script to try.
     *
     * @param source where it is kept
     * @param jarName the jar that it wants beside it
     * @param java a script that stands for Java: it makes the archives that it is asked for, and writes its words to LOG
     */
    StartScript(Path source, String jarName, String java) {
        this.source = source;
        this.jarName = jarName;
        this.java = java;
    }

    @BeforeEach
    void install() throws IOException {
        home = Files.createDirectories(folder.resolve("a jdk"));
        jar = folder.resolve(jarName);
        cache = folder.resolve("a cache/paprsek");
        log = folder.resolve("log");
        Files.createDirectory(home.resolve("bin"));
        Files.writeString(home.resolve("release"), "JAVA_VERSION=\"17.0.9\"\nMODULES=\"java.base jdk.incubator.vector\"\n");
        executable(home.resolve("bin/java"), java);
        executable(script(folder), Files.readString(source));
        Files.createFile(jar);
    }

    private static void executable(Path file, String text) throws IOException {
        Files.writeString(file, text);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private Path script(Path installation) {
        return installation.resolve(source.getFileName());
    }

    /** Calls the script of an installation. */
    final Answer call(Path installation, Map<String, String> environment, String... words) throws Exception {
        return call(new ProcessBuilder(script(installation).toString()), environment, words);
    }

    /** Calls the script as a shell does that has closed some of its streams, such as {@code >&-}. */
    final Answer callClosed(String closed, Map<String, String> environment, String... words) throws Exception {
        return call(new ProcessBuilder("sh", "-c", "exec \"$0\" \"$@\" " + closed, script(folder).toString()), environment, words);
    }

    private Answer call(ProcessBuilder builder, Map<String, String> environment, String... words) throws Exception {
        builder.redirectErrorStream(true);
        builder.command().addAll(List.of(words));
        builder.environment().put("JAVA_HOME", home.toString());
        builder.environment().put("XDG_CACHE_HOME", folder.resolve("a cache").toString());
        builder.environment().put("LOG", log.toString());
        builder.environment().putAll(environment);
        Process process = builder.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return new Answer(process.waitFor(), said);
    }

    /** All archives, when none is being made any more. */
    final List<Path> archives() throws Exception {
        while (Files.exists(cache.resolve("lock"))) {
            Thread.sleep(20);
        }
        try (Stream<Path> files = Files.list(cache)) {
            return files.toList();
        }
    }

    /** Calls the script without anything to do, and waits until it has made its archive if it needs one; what Java was asked for. */
    abstract String run(Path installation) throws Exception;

    private Path made(Path installation) throws Exception {
        assertThat(run(installation)).contains(MAKES);
        List<Path> all = archives();
        Path newest = all.get(0);
        for (Path archive : all) {
            newest = Files.getLastModifiedTime(archive).compareTo(Files.getLastModifiedTime(newest)) > 0 ? archive : newest;
        }
        return newest;
    }

    private void assertUses(Path installation, Path archive) throws Exception {
        assertThat(run(installation)).contains(USES + archive).doesNotContain(MAKES);
    }

    @Test
    void aSecondInstallationHasAnArchiveOfItsOwn() throws Exception {
        Path one = made(folder);
        Path second = Files.createDirectory(folder.resolve("the second"));
        for (Path file : List.of(script(folder), jar)) {
            Files.copy(file, second.resolve(file.getFileName()), StandardCopyOption.COPY_ATTRIBUTES);
        }
        Path other = made(second);
        assertThat(archives()).containsExactlyInAnyOrder(one, other);
        assertUses(second, other);
        assertUses(folder, one);
    }

    @Test
    void anotherJarInItsPlaceTakesThePlaceOfItsArchive() throws Exception {
        Path first = made(folder);
        Files.setLastModifiedTime(jar, FileTime.from(Instant.now().minusSeconds(100_000)));
        Path second = made(folder);
        assertThat(archives()).as("one for each place").containsExactly(second).doesNotContain(first);
        assertUses(folder, second);
    }

    @Test
    void withoutAFolderForItTheProgramStartsAllTheSame() throws Exception {
        Files.createFile(folder.resolve("a cache"));
        assertThat(run(folder)).doesNotContain(MAKES, USES).contains("-jar");
    }

    @Test
    void theTimeZoneMakesNoDifference() throws Exception {
        Files.setLastModifiedTime(jar, FileTime.from(Instant.parse("2024-05-05T23:30:00Z")));
        Path archive = made(folder);
        Files.deleteIfExists(log);
        call(folder, Map.of("TZ", "EST-10", "CODE", "0"));
        assertThat(Files.readString(log)).contains(USES + archive);
    }

    @Test
    void whoHasNoHomeHasNoArchive() throws Exception {
        call(folder, Map.of("HOME", "", "XDG_CACHE_HOME", "", "CODE", "0"));
        Thread.sleep(1500);
        assertThat(Files.readString(log)).contains("-jar").doesNotContain(MAKES, USES, "training");
    }

    @Test
    void allScriptsFindTheirArchiveAlike() throws IOException {
        List<String> same = Stream.of("src/main/launcher/paprsek", "../rt-fx/src/main/launcher/paprsek-editor").map(StartScript::common).toList();
        assertThat(same.get(0)).contains("cksum", "isFresh()").isEqualTo(same.get(1));
    }

    private static String common(String script) {
        try {
            String text = Files.readString(Path.of(script));
            return text.substring(text.indexOf("# ---- The same"), text.indexOf("# ---- Up to here"));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
