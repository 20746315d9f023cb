package cz.paprsek.xml;

import cz.paprsek.xml.format.CountingInput;
import java.io.InputStream;
import java.util.concurrent.CancellationException;

/** A stream that tells how much of it has been read. */
final class WatchedInput extends CountingInput {
    private final long total;
    private final ReadMonitor monitor;
    private long bytes;

    /** @param total how many bytes there are; 0 if that is not known */
    WatchedInput(InputStream input, long total, ReadMonitor monitor) {
        super(input);
        this.total = total;
        this.monitor = monitor;
    }

    /**
     * @throws CancellationException if the monitor wishes
     * @throws IllegalStateException if the monitor throws anything, with that as its cause: it must not be taken for a fault of the file
     */
    @Override
    protected void counted(int read) {
        bytes += read;
        boolean cancelled;
        try {
            cancelled = monitor.cancelled();
            if (!cancelled) {
                monitor.read(bytes, total);
            }
        } catch (Throwable thrown) {
            throw new IllegalStateException("the monitor of a reading failed: " + thrown, thrown);
        }
        if (cancelled) {
            throw new CancellationException("reading was cancelled");
        }
    }
}
