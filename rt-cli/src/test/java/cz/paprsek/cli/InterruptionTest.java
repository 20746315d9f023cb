package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The program as a process of its own, and a user who presses Ctrl-C. */
class InterruptionTest {
    private static final String SLOW = """
            <scene xmlns="urn:paprsek:scene:1">
              <render width="1500" height="1500" max-depth="20" samples="16"/>
              <camera position="0 0 5" direction="0 0 -1"/>
              <point-light position="3 3 5"/>
              <sphere radius="1"><material reflection="0.5" transparency="0.5" refractive-index="1.5"/></sphere>
            </scene>
            """;

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "signals are sent with kill")
    void controlCStopsAtOnceAndLeavesNoHalfPicture(@TempDir Path folder) throws IOException, InterruptedException {
        Path scene = Files.writeString(folder.resolve("slow.xml"), SLOW);
        Process process = start("render", scene.toString(), "-o", folder.resolve("slow.png").toString());
        Thread.sleep(2500);
        assertThat(process.isAlive()).as(new String(process.getErrorStream().readNBytes(process.getErrorStream().available()), StandardCharsets.UTF_8)).isTrue();
        boolean deaf = ignoresInterrupts();
        new ProcessBuilder("kill", deaf ? "-TERM" : "-INT", Long.toString(process.pid())).start().waitFor();
        assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
        assertThat(process.exitValue()).isEqualTo(deaf ? 128 + 15 : ExitCode.INTERRUPTED);
        assertThat(new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8)).contains("interrupted, nothing was written");
        assertThat(folder.toFile().list()).containsExactly("slow.xml");
    }

    @Test
    void theProcessEndsWithTheExitCodeOfTheCommand() throws IOException, InterruptedException {
        Process process = start("render", "none.xml");
        assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
        assertThat(process.exitValue()).isEqualTo(ExitCode.BAD_SCENE);
    }

    /** Whether this process was started in the background of a shell, which makes it and its children deaf to Ctrl-C. */
    private static boolean ignoresInterrupts() throws IOException {
        Path status = Path.of("/proc/self/status");
        return Files.exists(status) && Files.readAllLines(status).stream().filter(line -> line.startsWith("SigIgn:"))
                .anyMatch(line -> (Long.parseUnsignedLong(line.substring(7).trim(), 16) & 2) != 0);
    }

    private static Process start(String... args) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp", System.getProperty("java.class.path"), Main.class.getName());
        builder.command().addAll(java.util.List.of(args));
        return builder.start();
    }
}
