package cz.paprsek.fx.start;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.List;
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
    private Path archive;

    @BeforeEach
    void install() throws IOException {
        Path home = Files.createDirectories(folder.resolve("a jdk"));
        Files.createDirectory(home.resolve("bin"));
        Files.writeString(home.resolve("release"), "JAVA_VERSION=\"17.0.9\"\nMODULES=\"java.base jdk.incubator.vector\"\n");
        executable(home.resolve("bin/java"), JAVA);
        executable(folder.resolve("paprsek-editor"), Files.readString(Path.of("src/main/launcher/paprsek-editor")));
        Files.createFile(folder.resolve("rt-fx.jar"));
        archive = folder.resolve("a cache/paprsek/editor-17.0.9.archive");
    }

    private static void executable(Path file, String text) throws IOException {
        Files.writeString(file, text);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private List<String> call(int code, String... words) throws Exception {
        Path log = folder.resolve("log");
        Files.deleteIfExists(log);
        ProcessBuilder builder = new ProcessBuilder(folder.resolve("paprsek-editor").toString()).redirectErrorStream(true);
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
        assertThat(archive).exists();
        assertThat(call(3)).contains("-XX:SharedArchiveFile=" + archive).noneMatch(word -> word.startsWith("-XX:ArchiveClassesAtExit="));
        Files.setLastModifiedTime(folder.resolve("rt-fx.jar"), FileTime.from(Instant.now().plusSeconds(60)));
        assertThat(call(4)).as("an archive of another program").anyMatch(word -> word.startsWith("-XX:ArchiveClassesAtExit="));
        assertThat(archive.getParent()).as("nothing of a failed call stays").isDirectoryContaining(archive::equals).isDirectoryNotContaining(file -> !file.equals(archive));
    }

    @Test
    void withoutAFolderForItTheEditorStartsAllTheSame() throws Exception {
        Files.createFile(folder.resolve("a cache"));
        assertThat(call(0)).noneMatch(word -> word.startsWith("-XX:")).contains("-jar");
    }
}
