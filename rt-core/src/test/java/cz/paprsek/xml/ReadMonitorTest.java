package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.io.IOException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ReadMonitorTest {
    private static final String FILE = "<scene xmlns='urn:paprsek:scene:1'><camera position='0 1 5' direction='0 0 -1'/>" + "<sphere radius='1'/>\n".repeat(50_000) + "</scene>";
    /** Read twice: the quick reader gives up at its end. */
    private static final String UNUSUAL = FILE + "<?end?>";

    @TempDir
    private Path folder;

    /** All that takes a monitor. */
    enum Reading {
        READ {
            @Override
            void of(Path file, ReadMonitor monitor) throws SceneFileException, IOException {
                SceneFiles.read(file, monitor);
            }
        },
        READ_ALL {
            @Override
            void of(Path file, ReadMonitor monitor) throws SceneFileException, IOException {
                SceneFiles.readAll(file, monitor);
            }
        },
        CONTENTS {
            @Override
            void of(Path file, ReadMonitor monitor) throws SceneFileException, IOException {
                SceneFiles.contents(file, monitor);
            }
        },
        OPEN {
            @Override
            void of(Path file, ReadMonitor monitor) throws SceneFileException, IOException {
                SceneFiles.open(file, monitor);
            }
        };

        abstract void of(Path file, ReadMonitor monitor) throws SceneFileException, IOException;

        /** From a file and from one within an archive, usual or not. */
        void each(Path folder, ReadMonitor monitor, Check check) throws SceneFileException, IOException {
            Path archive = folder.resolve("a.zip");
            for (String content : List.of(FILE, UNUSUAL)) {
                try (FileSystem zip = FileSystems.newFileSystem(archive, Map.of("create", "true"))) {
                    Files.writeString(zip.getPath("/a.xml"), content);
                }
                try (FileSystem zip = FileSystems.newFileSystem(archive)) {
                    for (Path file : List.of(zip.getPath("/a.xml"), Files.writeString(folder.resolve("a.xml"), content))) {
                        check.of(() -> of(file, monitor), Files.size(file));
                    }
                }
            }
        }
    }

    private interface Check {
        void of(Read read, long size) throws SceneFileException, IOException;
    }

    private interface Read {
        void run() throws SceneFileException, IOException;
    }

    @ParameterizedTest
    @EnumSource
    void progressGoesOnToTheEnd(Reading reading) throws Exception {
        List<Long> told = new ArrayList<>();
        List<Long> totals = new ArrayList<>();
        ReadMonitor monitor = new ReadMonitor() {
            @Override
            public void read(long bytes, long total) {
                if (!told.isEmpty() && bytes < told.get(told.size() - 1)) {
                    told.clear();
                }
                told.add(bytes);
                totals.add(total);
            }
        };
        reading.each(folder, monitor, (read, size) -> {
            told.clear();
            totals.clear();
            read.run();
            assertThat(told).hasSizeGreaterThan(3).endsWith(size);
            assertThat(totals).containsOnly(size);
        });
    }

    @ParameterizedTest
    @EnumSource
    void aReadThatIsCancelledEnds(Reading reading) throws Exception {
        List<Long> told = new ArrayList<>();
        ReadMonitor impatient = new ReadMonitor() {
            @Override
            public boolean cancelled() {
                return !told.isEmpty() && told.get(told.size() - 1) > 300_000;
            }

            @Override
            public void read(long bytes, long total) {
                told.add(bytes);
            }
        };
        reading.each(folder, impatient, (read, size) -> {
            told.clear();
            assertThatExceptionOfType(CancellationException.class).isThrownBy(read::run);
            assertThat(told.get(told.size() - 1)).as("what was read").isLessThan(700_000);
        });
    }

    @ParameterizedTest
    @EnumSource
    void whatAMonitorThrowsIsTheCause(Reading reading) throws Exception {
        StackOverflowError thrown = new StackOverflowError();
        ReadMonitor failing = new ReadMonitor() {
            @Override
            public void read(long bytes, long total) {
                throw thrown;
            }
        };
        reading.each(folder, failing, (read, size) -> assertThatIllegalStateException().isThrownBy(read::run).withCause(thrown));
    }
}
