package cz.paprsek.io;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/**
 * Keeps all others, in this process or another, from changing a file until it is closed. Only who asks for the same lock is kept out; reading
 * needs none. The lock is a file beside the file, since the file itself is replaced when it is written.
 */
public final class FileLock implements AutoCloseable {
    private static final long MILLIS_BETWEEN = 20;
    /**
     * The lock files that this process has open. Whoever closes one lets go of all that the process holds of it, so that nobody here may so much
     * as open a lock file which somebody here has locked.
     */
    private static final Set<Path> OPEN = ConcurrentHashMap.newKeySet();

    private final Path file;
    private final FileChannel channel;

    private FileLock(Path file, FileChannel channel) {
        this.file = file;
        this.channel = channel;
    }

    /**
     * Waits until nobody else has the lock of a file, and takes it.
     *
     * @throws IOException with one line that names the file, if that takes longer than the time given, or there is no permission
     */
    public static FileLock of(Path target, long patienceMillis) throws IOException {
        Path real = Files.exists(target) ? target.toRealPath() : target.toAbsolutePath().normalize();
        Path file = AtomicFile.beside(real, ".", ".lock");
        long end = System.nanoTime() + patienceMillis * 1_000_000;
        while (true) {
            FileChannel channel = tryLock(target, file);
            if (channel != null) {
                return new FileLock(file, channel);
            }
            if (System.nanoTime() > end) {
                throw new IOException(target + ": somebody else is changing this file and does not come to an end; try again later");
            }
            try {
                Thread.sleep(MILLIS_BETWEEN);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new InterruptedIOException(target + ": interrupted");
            }
        }
    }

    /** The file's channel, locked; null if somebody else has it. */
    private static @Nullable FileChannel tryLock(Path target, Path file) throws IOException {
        if (!OPEN.add(file)) {
            return null;
        }
        FileChannel channel = null;
        try {
            channel = tryLock(file);
            return channel;
        } catch (NoSuchFileException e) {
            throw new IOException(target + ": cannot be written, there is no such folder", e);
        } catch (IOException e) {
            throw new IOException(target + ": cannot be changed, its folder does not let a lock be made", e);
        } finally {
            if (channel == null) {
                OPEN.remove(file);
            }
        }
    }

    /**
     * As above. Whoever had the lock before has removed the file, and a lock of a file without a name keeps nobody out: the name must lead to one
     * and the same file before it is opened, after that, and when it is locked.
     */
    private static @Nullable FileChannel tryLock(Path file) throws IOException {
        Optional<Object> before = identity(file);
        if (before.isEmpty()) {
            create(file);
            before = identity(file);
        }
        FileChannel channel = before.isEmpty() ? null : open(file);
        if (channel == null) {
            return null;
        }
        boolean isOurs = false;
        try {
            isOurs = before.equals(identity(file)) && channel.tryLock() != null && before.equals(identity(file));
            return isOurs ? channel : null;
        } finally {
            if (!isOurs) {
                channel.close();
            }
        }
    }

    private static void create(Path file) throws IOException {
        try {
            Files.createFile(file);
        } catch (FileAlreadyExistsException somebodyElseWas) {
            // Quicker. That file serves as well.
        }
    }

    /** Null if the file has been removed meanwhile. */
    private static @Nullable FileChannel open(Path file) throws IOException {
        try {
            return FileChannel.open(file, StandardOpenOption.WRITE);
        } catch (NoSuchFileException removed) {
            return null;
        }
    }

    /** What tells the file from any other that has had its name; empty if there is none. Learnt without opening it. */
    private static Optional<Object> identity(Path file) throws IOException {
        try {
            BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
            return Optional.of(attributes.fileKey() == null ? attributes.creationTime() : attributes.fileKey());
        } catch (NoSuchFileException none) {
            return Optional.empty();
        }
    }

    /** Gives the lock back. */
    @Override
    public void close() throws IOException {
        try {
            Files.deleteIfExists(file);
        } finally {
            channel.close();
            OPEN.remove(file);
        }
    }
}
