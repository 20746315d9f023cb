package cz.paprsek.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class AtomicFileTest {
    @TempDir
    Path folder;

    private Path old() throws IOException {
        return Files.writeString(folder.resolve("picture.bin"), "old");
    }

    @Test
    void aFailingWriteLeavesTheOldFileWhole() throws IOException {
        Path file = old();
        assertThatThrownBy(() -> AtomicFile.write(file, out -> {
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
            assertThatThrownBy(() -> AtomicFile.write(file, out -> {
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
    void whatAKilledProcessLeftIsSweptAwayAndNothingElse() throws Exception {
        Process gone = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-version").start();
        gone.waitFor();
        Path file = old();
        Path left = ofProcess(file, gone.pid(), 3600);
        Path alive = ofProcess(file, ProcessHandle.current().pid(), 3600);
        Path recent = ofProcess(file, gone.pid(), 0);
        Path other = ofProcess(folder.resolve("other.bin"), gone.pid(), 3600);
        AtomicFile.write(file, out -> out.write('n'));
        assertThat(left).doesNotExist();
        assertThat(List.of(alive, recent, other)).allMatch(Files::exists);
        assertThat(file).hasContent("n");
    }

    private static Path ofProcess(Path file, long process, long secondsOld) throws IOException {
        Path half = Files.writeString(file.resolveSibling(file.getFileName() + "." + process + "-" + Long.toHexString(secondsOld) + ".tmp"), "half");
        return Files.setLastModifiedTime(half, FileTime.from(Instant.now().minusSeconds(secondsOld)));
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void aFullDiskIsToldAndTheOldFileStays() throws Exception {
        Path disk = Files.createDirectory(folder.resolve("disk"));
        assumeTrue(run("mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", disk.toString()), "small disks can be mounted by root only");
        try {
            Path file = Files.writeString(disk.resolve("picture.bin"), "old");
            assertThatThrownBy(() -> AtomicFile.write(file, out -> out.write(new byte[200_000])))
                    .isInstanceOf(IOException.class).hasMessage(file + ": no space left on device");
            assertThat(file).hasContent("old");
            assertThat(disk.toFile().list()).containsExactly("picture.bin");
        } finally {
            run("umount", disk.toString());
        }
    }

    /** By its own name, not that of the file that was to become it. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void aDiskThatMayOnlyBeReadIsToldByTheNameOfTheFile() throws Exception {
        Path disk = Files.createDirectory(folder.resolve("disk"));
        assumeTrue(run("mount", "-t", "tmpfs", "-o", "ro,size=64k", "tmpfs", disk.toString()), "disks can be mounted by root only");
        try {
            Path file = disk.resolve("picture.bin");
            String sentence = file + ": read-only file system";
            assertThatThrownBy(() -> AtomicFile.write(file, out -> out.write(1))).isInstanceOf(IOException.class).hasMessage(sentence);
            assertThatThrownBy(() -> AtomicFile.check(file)).isInstanceOf(IOException.class).hasMessage(sentence);
        } finally {
            run("umount", disk.toString());
        }
    }

    @Test
    void whatTheContentFailsAtIsLeftAsItIs() {
        IOException other = new FileSystemException("other.bin", null, "Input/output error");
        assertThatThrownBy(() -> AtomicFile.write(old(), out -> { throw other; })).isSameAs(other);
        assertThatThrownBy(() -> AtomicFile.write(old(), out -> { throw new IOException("no scene can say that"); })).hasMessage("no scene can say that");
    }

    /** What is copied may lie on a disk that is broken: here, the memory that nobody may read at its beginning. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void whatCannotBeReadIsNotTakenForWhatIsWritten() {
        assertThatThrownBy(() -> AtomicFile.write(old(), out -> Files.copy(Path.of("/proc/self/mem"), out))).isInstanceOf(IOException.class).hasMessage("Input/output error");
    }

    private static boolean run(String... command) throws Exception {
        return new ProcessBuilder(command).start().waitFor() == 0;
    }

    @Test
    void aDirectoryIsNotReplaced() {
        assertThatThrownBy(() -> AtomicFile.write(folder, out -> out.write(1)))
                .isInstanceOf(IOException.class).hasMessageContaining("this is a directory");
    }

    @Test
    void aMissingFolderIsNamed() {
        assertThatThrownBy(() -> AtomicFile.write(folder.resolve("no/a.png"), out -> out.write(1)))
                .isInstanceOf(IOException.class).hasMessageContaining("there is no such folder");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void anExistingFileKeepsItsPermissionsAndItsLink() throws IOException {
        Path file = old();
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-rw-r--"));
        Path link = Files.createSymbolicLink(folder.resolve("link"), file.getFileName());
        AtomicFile.write(link, out -> out.write('n'));
        assertThat(link).isSymbolicLink();
        assertThat(file).hasContent("n");
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file))).isEqualTo("rw-rw-r--");
    }

    /** A pipe of our own, for a device would be gone if this failed. */
    @Test
    @DisabledOnOs(OS.WINDOWS)
    @Timeout(20)
    void aPipeOrDeviceIsWrittenToAndStaysOne() throws Exception {
        Path pipe = folder.resolve("pipe");
        assumeTrue(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0);
        CompletableFuture<byte[]> read = CompletableFuture.supplyAsync(() -> {
            try {
                return Files.readAllBytes(pipe);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        });
        AtomicFile.write(pipe, out -> out.write('n'));
        assertThat(Files.isRegularFile(pipe)).isFalse();
        assertThat(read.get()).containsExactly('n');
    }

    @Test
    void aNameOf255BytesIsWritten() throws IOException {
        for (String name : List.of("x".repeat(255), "é".repeat(127) + "x", "x".repeat(230))) {
            Path file = folder.resolve(name);
            AtomicFile.check(file);
            AtomicFile.write(file, out -> out.write(1));
            assertThat(file).hasBinaryContent(new byte[] {1});
            assertThat(AtomicFile.beside(file, ".", ".lock").getFileName().toString().getBytes(StandardCharsets.UTF_8)).hasSizeLessThanOrEqualTo(255);
            Files.delete(file);
        }
        assertThat(folder).isEmptyDirectory();
        assertThat(AtomicFile.beside(folder.resolve("x".repeat(254) + "a"), "", ".resume"))
                .isNotEqualTo(AtomicFile.beside(folder.resolve("x".repeat(254) + "b"), "", ".resume"));
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aLinkToNothingMakesTheFileItPointsTo() throws IOException {
        Path folders = Files.createDirectories(folder.resolve("a/b"));
        Path link = Files.createSymbolicLink(folder.resolve("link.png"), Path.of("a/second"));
        Files.createSymbolicLink(folder.resolve("a/second"), Path.of("b/real.png"));
        AtomicFile.write(link, out -> out.write(1));
        assertThat(folders.resolve("real.png")).hasBinaryContent(new byte[] {1});
        assertThat(link).isSymbolicLink();
        Path circle = Files.createSymbolicLink(folder.resolve("circle"), Path.of("circle"));
        assertThatThrownBy(() -> AtomicFile.write(circle, out -> out.write(1))).isInstanceOf(IOException.class).hasMessageContaining("leads to itself");
    }

    @Test
    void whatCannotBeWrittenIsKnownBeforehandAndNothingIsLeft() throws IOException {
        assertThatThrownBy(() -> AtomicFile.check(folder)).hasMessageContaining("this is a directory");
        assertThatThrownBy(() -> AtomicFile.check(folder.resolve("none/x"))).hasMessageContaining("no such folder");
        assertThatThrownBy(() -> AtomicFile.check(folder.resolve("x".repeat(256)))).isInstanceOf(IOException.class);
        Path old = Files.writeString(folder.resolve("old"), "old");
        AtomicFile.check(old);
        AtomicFile.check(folder.resolve("new"));
        assertThat(folder.toFile().list()).containsExactly("old");
        assertThat(old).hasContent("old");
    }

    /** Such as somebody else's in a folder of all: here a folder that is not empty. */
    @Test
    void whatCannotBeRemovedOfWhatWasLeftIsLeft(@TempDir Path folder) throws Exception {
        Path kept = folder.resolve("a.part.999999999-1.tmp");
        Files.createDirectories(kept.resolve("full"));
        Path gone = Files.writeString(folder.resolve("b.part.999999999-2.tmp"), "half");
        for (Path one : List.of(kept, gone)) {
            Files.setLastModifiedTime(one, FileTime.from(Instant.now().minusSeconds(3600)));
        }
        AtomicFile.sweepAll(folder, ".part");
        assertThat(kept).exists();
        assertThat(gone).doesNotExist();
    }
}
