package cz.paprsek.io;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;

/** Replaces files as a whole: the new one is written beside the old and moved into its place, so that nobody ever sees half a file. */
public final class AtomicFile {
    private AtomicFile() {}

    /** Writes the content of a file to a stream. */
    @FunctionalInterface
    public interface Content {
        void writeTo(OutputStream out) throws IOException;
    }

    /**
     * Replaces or creates a file; an old file's permissions are kept.
     *
     * @throws IOException with one line that names the file, if it cannot be written; what was there before is still there
     */
    public static void write(Path file, Content content) throws IOException {
        if (Files.isDirectory(file)) {
            throw new IOException(file + ": this is a directory, not a file");
        }
        // A link is followed: the file it leads to is replaced, not the link.
        Path target = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
        Path fresh = target.resolveSibling(target.getFileName() + "." + Long.toHexString(System.nanoTime()) + ".tmp");
        try {
            // Not createTempFile, whose files are readable by their owner alone, whatever the old file was.
            try (OutputStream out = new BufferedOutputStream(
                    Files.newOutputStream(fresh, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE), 1 << 16)) {
                content.writeTo(out);
            }
            PosixFileAttributeView old = Files.exists(target) ? Files.getFileAttributeView(target, PosixFileAttributeView.class) : null;
            if (old != null) {
                Files.setPosixFilePermissions(fresh, old.readAttributes().permissions());
            }
            Files.move(fresh, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } catch (NoSuchFileException e) {
            throw new IOException(file + ": cannot be written, there is no such folder", e);
        } catch (AccessDeniedException e) {
            throw new IOException(file + ": cannot be written, permission denied", e);
        } finally {
            Files.deleteIfExists(fresh);
        }
    }
}
