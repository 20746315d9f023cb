package cz.paprsek.cli.start;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** The editor's: Java makes the archive when the first window is closed. */
class EditorScriptTest extends StartScript {
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

    EditorScriptTest() {
        super(Path.of("../rt-fx/src/main/launcher/paprsek-editor"), "rt-fx.jar", JAVA);
    }

    @Override
    String run(Path installation) throws Exception {
        return String.join("\n", call(installation, 0));
    }

    private List<String> call(Path installation, int code, String... words) throws Exception {
        Files.deleteIfExists(log);
        assertThat(call(installation, Map.of("CODE", String.valueOf(code)), words)).isEqualTo(new Answer(code, "told\n"));
        return Files.readAllLines(log);
    }

    @Test
    void closedStreamsKeepNothingFromStarting() throws Exception {
        assertThat(callClosed(">&-", Map.of("CODE", "5"))).isEqualTo(new Answer(5, "told\n"));
        assertThat(callClosed(">&- 2>&-", Map.of("CODE", "6"))).isEqualTo(new Answer(6, ""));
    }

    @Test
    void theFirstCallMakesTheArchiveThatTheOthersUse() throws Exception {
        assertThat(call(folder, 0, "a scene.xml")).anyMatch(word -> word.startsWith("-XX:ArchiveClassesAtExit="))
                .contains("-Dpaprsek.archive=true", "--add-modules", "-jar", "a scene.xml");
        Path archive = archives().get(0);
        assertThat(call(folder, 3)).contains("-XX:SharedArchiveFile=" + archive)
                .noneMatch(word -> word.startsWith("-XX:ArchiveClassesAtExit=") || word.startsWith("-Dpaprsek.archive"));
        Files.setLastModifiedTime(jar, FileTime.from(Instant.now().plusSeconds(60)));
        assertThat(call(folder, 4)).as("an archive of another program").anyMatch(word -> word.startsWith("-XX:ArchiveClassesAtExit="));
        assertThat(archives()).as("nothing of a failed call stays").containsExactly(archive);
    }
}
