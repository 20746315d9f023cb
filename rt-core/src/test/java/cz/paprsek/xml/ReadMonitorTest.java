package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ReadMonitorTest {
    private static final String START = "<scene xmlns='urn:paprsek:scene:1'><camera position='0 1 5' direction='0 0 -1'/>";

    @TempDir
    private Path folder;

    @Test
    void progressGoesOnToTheEnd() throws Exception {
        Path file = Files.writeString(folder.resolve("a.xml"), START + "<sphere radius='1'/>\n".repeat(50_000) + "</scene>");
        List<Long> told = new ArrayList<>();
        SceneFiles.read(file, new ReadMonitor() {
            @Override
            public void read(long bytes, long total) {
                assertThat(total).isEqualTo(file.toFile().length());
                told.add(bytes);
            }
        });
        assertThat(told).hasSizeGreaterThan(3).isSorted().endsWith(file.toFile().length());
    }

    @Test
    void aReadThatIsCancelledEnds() throws Exception {
        Path file = Files.writeString(folder.resolve("a.xml"), START + "<sphere radius='1'/>\n".repeat(50_000) + "</scene>");
        ReadMonitor impatient = new ReadMonitor() {
            private long read;

            @Override
            public boolean cancelled() {
                return read > 300_000;
            }

            @Override
            public void read(long bytes, long total) {
                assertThat(read).as("what was read before").isLessThan(700_000);
                read = bytes;
            }
        };
        assertThatExceptionOfType(CancellationException.class).isThrownBy(() -> SceneFiles.read(file, impatient));
    }
}
