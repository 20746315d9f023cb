package cz.paprsek.cli.process;

import cz.paprsek.io.Folders;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/**
 * The user's wish to stop, told to the one thread that runs the command. Computing stops by asking {@link #requested}; a file being
 * written is given up by interrupting the thread, and waited for, so that no half of it stays behind.
 */
public final class Stop {
    /** How long a process that writes nothing is kept alive to say that it was interrupted. */
    private static final long LAST_WORDS_MILLIS = 20;
    /** How long to wait for a half-written file to be removed, or for words that were promised: more than that, and something hangs. */
    private static final long CLEANING_MILLIS = 5_000;

    private volatile boolean requested;
    private @Nullable Thread writer;
    private boolean owesLastWords;
    private boolean ended;

    /** Writes a file. */
    @FunctionalInterface
    public interface Writing {
        void run() throws IOException;
    }

    public boolean requested() {
        return requested;
    }

    /** Asks the command to stop. */
    public synchronized void request() {
        requested = true;
        if (writer != null) {
            writer.interrupt();
        }
    }

    /** Asks the command to stop and gives it the time to clean up. */
    public synchronized void requestAndWait() {
        request();
        long begin = System.nanoTime();
        try {
            for (long left = 1; !ended && left > 0;) {
                long patience = writer == null && !owesLastWords ? LAST_WORDS_MILLIS : CLEANING_MILLIS;
                left = patience - (System.nanoTime() - begin) / 1_000_000;
                wait(Math.max(1, left));
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Whoever reads the results is promised to be told of the end, so that it is waited for. */
    public synchronized void oweLastWords() {
        owesLastWords = true;
    }

    /** The command is over. */
    public synchronized void ended() {
        ended = true;
        notifyAll();
    }

    /**
     * Writes a file, as {@link #guard} does, into a folder that is made if it is not there.
     *
     * @throws IOException also if the folder cannot be made
     */
    public void write(Path file, Writing writing) throws IOException {
        guard(() -> {
            Folders.makeFor(file);
            writing.run();
        });
    }

    /** Writes a file unless a stop was asked for; a stop asked for meanwhile interrupts it. */
    public void guard(Writing writing) throws IOException {
        synchronized (this) {
            if (requested) {
                throw new InterruptedIOException("interrupted");
            }
            writer = Thread.currentThread();
        }
        try {
            writing.run();
        } finally {
            synchronized (this) {
                writer = null;
                if (requested) {
                    // The interrupt was meant for this file only.
                    Thread.interrupted();
                }
                notifyAll();
            }
        }
    }
}
