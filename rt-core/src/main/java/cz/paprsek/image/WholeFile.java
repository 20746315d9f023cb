package cz.paprsek.image;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;

/** Writes files as a whole or not at all: a new one is written beside the old and moved into its place. */
public final class WholeFile {
    private WholeFile() {}

    /** Writes what a file is to hold. */
    @FunctionalInterface
    public interface Content {
        void writeTo(OutputStream out) throws IOException;
    }

    /**
     * Replaces or creates a file. An existing one keeps its permissions, a symbolic link stays and what it points to is replaced. A
     * device or pipe is written to directly.
     *
     * @throws IOException if that fails or the thread is interrupted; what was there before is then still there, whole
     */
    public static void write(Path file, Content content) throws IOException {
        boolean exists = Files.exists(file);
        if (exists && Files.isDirectory(file)) {
            throw new FileSystemException(file.toString(), null, "this is a directory");
        }
        if (exists && !Files.isWritable(file)) {
            throw new AccessDeniedException(file.toString(), null, "no permission to write this file");
        }
        if (exists && !Files.isRegularFile(file)) {
            fill(file, content, StandardOpenOption.WRITE);
            return;
        }
        Path target = exists ? file.toRealPath() : file.toAbsolutePath();
        Path folder = target.getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw new NoSuchFileException(file.toString(), null, "there is no directory " + folder);
        }
        replace(target, content);
    }

    private static void replace(Path target, Content content) throws IOException {
        Path fresh = target.resolveSibling(target.getFileName() + "." + Long.toHexString(System.nanoTime()) + ".tmp");
        try {
            // Not createTempFile, whose files are readable by their owner alone, whatever the old file was.
            fill(fresh, content, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
            PosixFileAttributeView old = Files.exists(target) ? Files.getFileAttributeView(target, PosixFileAttributeView.class) : null;
            if (old != null) {
                Files.setPosixFilePermissions(fresh, old.readAttributes().permissions());
            }
            Files.move(fresh, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(fresh);
        }
    }

    private static void fill(Path file, Content content, StandardOpenOption... how) throws IOException {
        // Not newOutputStream: an interrupt of the thread closes a channel, and that is how a write is stopped half-way.
        try (OutputStream out = new BufferedOutputStream(Channels.newOutputStream(Files.newByteChannel(file, how)), 1 << 16)) {
            content.writeTo(out);
        }
    }
}
