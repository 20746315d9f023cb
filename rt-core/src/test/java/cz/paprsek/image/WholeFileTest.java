package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class WholeFileTest {
    @TempDir
    Path folder;

    private Path old() throws IOException {
        return Files.writeString(folder.resolve("picture.bin"), "old");
    }

    @Test
    void aFailingWriteLeavesTheOldFileWhole() throws IOException {
        Path file = old();
        assertThatThrownBy(() -> WholeFile.write(file, out -> {
            out.write(new byte[200_000]);
            throw new IOException("disk full");
        })).isInstanceOf(IOException.class).hasMessage("disk full");
        assertThat(file).hasContent("old");
        assertThat(folder.toFile().list()).containsExactly("picture.bin");
    }

    @Test
    void anInterruptedWriteLeavesNothingNew() {
        Path file = folder.resolve("picture.bin");
        try {
            assertThatThrownBy(() -> WholeFile.write(file, out -> {
                out.write(new byte[200_000]);
                Thread.currentThread().interrupt();
                out.write(new byte[200_000]);
            })).isInstanceOf(IOException.class);
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aDirectoryIsNotReplaced() {
        assertThatThrownBy(() -> WholeFile.write(folder, out -> out.write(1)))
                .isInstanceOf(IOException.class).hasMessageContaining("this is a directory");
    }

    @Test
    void aMissingDirectoryIsNamed() {
        assertThatThrownBy(() -> WholeFile.write(folder.resolve("no/a.png"), out -> out.write(1)))
                .isInstanceOf(IOException.class).hasMessageContaining("there is no directory");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void anExistingFileKeepsItsPermissionsAndItsLink() throws IOException {
        Path file = old();
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-rw-r--"));
        Path link = Files.createSymbolicLink(folder.resolve("link"), file.getFileName());
        WholeFile.write(link, out -> out.write('n'));
        assertThat(link).isSymbolicLink();
        assertThat(file).hasContent("n");
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file))).isEqualTo("rw-rw-r--");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aDeviceIsWrittenToAndStaysOne() throws IOException {
        Path device = Path.of("/dev/null");
        WholeFile.write(device, out -> out.write(1));
        assertThat(Files.isRegularFile(device)).isFalse();
    }
}
