package cz.paprsek.fx.start;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The script that starts the editor, with a Java that only writes down what it was asked for. */
@DisabledOnOs(OS.WINDOWS)
@Timeout(60)
class StartScriptTest {
    private static final String JAVA = """
            #!/bin/sh
            for word; do
                case $word in -XX:ArchiveClassesAtExit=*) : > "${word#*=}" ;; esac
                echo "$word" >> "$LOG"
            done
            echo "WARNING: Using incubator modules: jdk.incubator.vector" >&2
            echo told >&2
            exit $CODE
            """;

    @TempDir
    Path folder;

    @BeforeEach
    void install() throws IOException {
        Path home = Files.createDirectories(folder.resolve("a jdk"));
        Files.createDirectory(home.resolve("bin"));
        Files.writeString(home.resolve("release"), "JAVA_VERSION=\"17.0.9\"\nMODULES=\"java.base jdk.incubator.vector\"\n");
        executable(home.resolve("bin/java"), JAVA);
        executable(folder.resolve("paprsek-editor"), Files.readString(Path.of("src/main/launcher/paprsek-editor")));
        Files.createFile(folder.resolve("rt-fx.jar"));
    }

    private static void executable(Path file, String text) throws IOException {
        Files.writeString(file, text);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private List<Path> archives() throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve("a cache/paprsek"))) {
            return files.toList();
        }
    }

    private void date(int seconds) throws IOException {
        Files.setLastModifiedTime(folder.resolve("rt-fx.jar"), FileTime.from(Instant.now().plusSeconds(seconds)));
    }

    private List<String> call(int code, String... words) throws Exception {
        return callOf(folder, code, words);
    }

    private List<String> callOf(Path installation, int code, String... words) throws Exception {
        Path log = folder.resolve("log");
        Files.deleteIfExists(log);
        ProcessBuilder builder = new ProcessBuilder(installation.resolve("paprsek-editor").toString()).redirectErrorStream(true);
        builder.command().addAll(List.of(words));
        builder.environment().put("JAVA_HOME", folder.resolve("a jdk").toString());
        builder.environment().put("XDG_CACHE_HOME", folder.resolve("a cache").toString());
        builder.environment().put("LOG", log.toString());
        builder.environment().put("CODE", String.valueOf(code));
        Process process = builder.start();
        assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)).isEqualTo("told\n");
        assertThat(process.waitFor()).isEqualTo(code);
        return Files.readAllLines(log);
    }

    @Test
    void theFirstCallMakesTheArchiveThatTheOthersUse() throws Exception {
        assertThat(call(0, "a scene.xml")).anyMatch(word -> word.startsWith("-XX:ArchiveClassesAtExit=")).contains("--add-modules", "-jar", "a scene.xml");
        Path archive = archives().get(0);
        assertThat(call(3)).contains("-XX:SharedArchiveFile=" + archive).noneMatch(word -> word.startsWith("-XX:ArchiveClassesAtExit="));
        date(60);
        assertThat(call(4)).as("an archive of another program").anyMatch(word -> word.startsWith("-XX:ArchiveClassesAtExit="));
        assertThat(archives()).as("nothing of a failed call stays").containsExactly(archive);
    }

    @Test
    void anOlderProgramHasAnArchiveOfItsOwnToo() throws Exception {
        call(0);
        Path first = archives().get(0);
        date(-100_000);
        assertThat(call(0)).as("an older jar in its place").anyMatch(word -> word.startsWith("-XX:ArchiveClassesAtExit="));
        assertThat(archives()).as("one for each place").hasSize(1).doesNotContain(first);
        Path second = Files.createDirectory(folder.resolve("second"));
        for (String file : List.of("paprsek-editor", "rt-fx.jar")) {
            Files.copy(folder.resolve(file), second.resolve(file), StandardCopyOption.COPY_ATTRIBUTES);
        }
        assertThat(callOf(second, 0)).as("elsewhere").anyMatch(word -> word.startsWith("-XX:ArchiveClassesAtExit="));
        assertThat(archives()).hasSize(2);
        assertThat(callOf(second, 0)).anyMatch(word -> word.startsWith("-XX:SharedArchiveFile="));
        assertThat(call(0)).anyMatch(word -> word.startsWith("-XX:SharedArchiveFile="));
    }

    @Test
    void withoutAFolderForItTheEditorStartsAllTheSame() throws Exception {
        Files.createFile(folder.resolve("a cache"));
        assertThat(call(0)).noneMatch(word -> word.startsWith("-XX:")).contains("-jar");
    }
}
