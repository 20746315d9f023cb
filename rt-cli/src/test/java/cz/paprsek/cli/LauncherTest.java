package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.concurrent.TimeUnit;
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
        ProcessBuilder builder = new ProcessBuilder(folder.resolve("paprsek").toString()).redirectErrorStream(true);
        builder.command().addAll(List.of(words));
        builder.environment().put("JAVA_HOME", folder.resolve("jdk").toString());
        builder.environment().put("XDG_CACHE_HOME", folder.resolve("cache").toString());
        builder.environment().put("LOG", log.toString());
        Process process = builder.start();
        assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)).isEmpty();
        assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
        return process.exitValue();
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
}
