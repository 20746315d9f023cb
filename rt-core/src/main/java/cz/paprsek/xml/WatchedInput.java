package cz.paprsek.xml;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;

/** A file as a stream that tells how much of it has been read. */
final class WatchedInput extends FilterInputStream {
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
    public int read() throws IOException {
        int read = super.read();
        tell(read < 0 ? 0 : 1);
        return read;
    }

    /** @throws CancellationException if the monitor wishes */
    @Override
    public int read(byte[] into, int offset, int length) throws IOException {
        int read = super.read(into, offset, length);
        tell(Math.max(0, read));
        return read;
    }

    private void tell(int read) {
        if (monitor.cancelled()) {
            throw new CancellationException("reading was cancelled");
        }
        bytes += read;
        monitor.read(bytes, total);
    }
}
