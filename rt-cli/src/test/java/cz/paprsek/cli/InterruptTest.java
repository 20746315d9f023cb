package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.ExitCode;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** A process of its own is stopped as a user stops it. */
@EnabledOnOs({OS.LINUX, OS.MAC})
class InterruptTest {
    @TempDir
    Path folder;

    @Test
    @Timeout(60)
    void interruptingARenderExitsWith130AndKeepsTheOldPicture() throws Exception {
        boolean deaf = interruptsAreIgnored();
        Path picture = Files.writeString(folder.resolve("picture.png"), "old");
        Process process = new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp", System.getProperty("java.class.path"),
                Main.class.getName(), "render", Path.of("../scenes/showcase.xml").toString(), "--size", "4000x4000", "--samples", "16",
                "-o", picture.toString())
                .start();
        try (BufferedReader messages = process.errorReader(StandardCharsets.UTF_8)) {
            assertThat(messages.readLine()).contains("rendering 4000x4000");
            // Into the middle of the tracing.
            Thread.sleep(300);
            long begin = System.nanoTime();
            new ProcessBuilder("kill", deaf ? "-TERM" : "-INT", Long.toString(process.pid())).start().waitFor();
            assertThat(process.waitFor(10, TimeUnit.SECONDS)).isTrue();
            // Twenty times what is promised: this machine may be busy with other things.
            assertThat((System.nanoTime() - begin) / 1e6).as("milliseconds").isLessThan(1000);
            // A process on a busy machine ends before it finds the time to say so.
            assertThat(messages.lines()).allMatch(line -> line.endsWith("interrupted, no picture written"));
        } finally {
            process.destroyForcibly();
        }
        assertThat(process.exitValue()).isEqualTo(deaf ? 128 + 15 : ExitCode.INTERRUPTED);
        assertThat(picture).hasContent("old");
        assertThat(folder.toFile().list()).containsExactly("picture.png");
    }

    @Test
    @Timeout(60)
    void interruptingPathsKeepsThePassesThatWereComplete() throws Exception {
        boolean deaf = interruptsAreIgnored();
        Path picture = folder.resolve("picture.png");
        Process process = new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp", System.getProperty("java.class.path"),
                Main.class.getName(), "render", Path.of("../scenes/cornell.xml").toString(), "--size", "8x8", "--samples", "1000000", "-o", picture.toString())
                .start();
        try (BufferedReader messages = process.errorReader(StandardCharsets.UTF_8)) {
            assertThat(messages.readLine()).contains("rendering 8x8");
            while (!Files.exists(picture)) {
                Thread.sleep(20);
            }
            new ProcessBuilder("kill", deaf ? "-TERM" : "-INT", Long.toString(process.pid())).start().waitFor();
            assertThat(process.waitFor(10, TimeUnit.SECONDS)).isTrue();
            assertThat(messages.lines()).allMatch(line -> line.endsWith("paths a pixel that were complete"));
        } finally {
            process.destroyForcibly();
        }
        assertThat(process.exitValue()).isEqualTo(deaf ? 128 + 15 : ExitCode.INTERRUPTED);
        assertThat(ImageIO.read(picture.toFile()).getWidth()).isEqualTo(8);
        assertThat(folder.toFile().list()).containsExactly("picture.png");
    }

    /** Shells start background jobs so, and children inherit it; then another signal has to do. */
    private static boolean interruptsAreIgnored() throws IOException {
        Path status = Path.of("/proc/self/status");
        if (!Files.exists(status)) {
            return false;
        }
        return Files.readAllLines(status).stream().filter(line -> line.startsWith("SigIgn:"))
                .anyMatch(line -> (Long.parseUnsignedLong(line.substring(7).strip(), 16) & 2) != 0);
    }
}
