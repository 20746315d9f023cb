package cz.paprsek.io;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.UUID;
import org.jspecify.annotations.Nullable;

/**
 * Keeps all others, in this process or another, from changing a file until it is closed. Only who asks for the same lock is kept out; reading
 * needs none. The lock is a file beside the file, since the file itself is replaced when it is written.
 */
public final class FileLock implements AutoCloseable {
    private static final long MILLIS_BETWEEN = 20;

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
        Path real = Files.exists(target) ? target.toRealPath() : target.toAbsolutePath();
        Path file = real.resolveSibling("." + real.getFileName() + ".lock");
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
        FileChannel channel;
        try {
            channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        } catch (NoSuchFileException e) {
            throw new IOException(target + ": cannot be written, there is no such folder", e);
        } catch (IOException e) {
            throw new IOException(target + ": cannot be changed, its folder does not let a lock be made", e);
        }
        boolean isOurs = false;
        try {
            // Beyond all content, so that the mark can be read on systems that let nobody read what is locked.
            isOurs = channel.tryLock(Long.MAX_VALUE - 1, 1, false) != null && isStillThere(file, channel);
        } catch (OverlappingFileLockException heldByThisProcess) {
            // As if another process held it.
        } finally {
            if (!isOurs) {
                channel.close();
            }
        }
        return isOurs ? channel : null;
    }

    /**
     * Whether the name still leads to the file that is locked. Whoever had the lock before has removed the file, and a lock of a file without a
     * name keeps nobody out. Told by a mark that only the owner of the lock writes.
     */
    private static boolean isStillThere(Path file, FileChannel channel) throws IOException {
        byte[] mark = UUID.randomUUID().toString().getBytes(StandardCharsets.US_ASCII);
        channel.truncate(0).write(ByteBuffer.wrap(mark), 0);
        try {
            return Arrays.equals(Files.readAllBytes(file), mark);
        } catch (NoSuchFileException removed) {
            return false;
        }
    }

    /** Gives the lock back. */
    @Override
    public void close() throws IOException {
        try {
            Files.deleteIfExists(file);
        } finally {
            channel.close();
        }
    }
}
