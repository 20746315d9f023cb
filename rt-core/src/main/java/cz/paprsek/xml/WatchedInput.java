package cz.paprsek.xml;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;

/** A file as a stream that tells how much of it has been read. */
final class WatchedInput extends CountingInput {
    private final long total;
    private final ReadMonitor monitor;
    private long bytes;

    WatchedInput(Path file, ReadMonitor monitor) throws IOException {
        super(Files.newInputStream(file));
        this.monitor = monitor;
        total = Files.size(file);
    }

    /** @throws CancellationException if the monitor wishes */
    @Override
    void counted(int read) {
        if (monitor.cancelled()) {
            throw new CancellationException("reading was cancelled");
        }
        bytes += read;
        monitor.read(bytes, total);
    }
}
