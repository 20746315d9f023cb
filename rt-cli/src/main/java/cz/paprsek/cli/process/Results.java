package cz.paprsek.cli.process;

import cz.paprsek.io.Failures;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** Standard output, which keeps in mind whether anything got lost: what prints lines does not ask. */
public final class Results extends OutputStream {
    private final OutputStream out;
    private @Nullable IOException failure;
    private boolean areLinesLost;

    public Results(OutputStream out) {
        super();
        this.out = out;
    }

    /** Why something that was written did not arrive, if so. */
    public synchronized Optional<IOException> lost() {
        return Optional.ofNullable(failure);
    }

    /** Whether it was a line that did not arrive first, which nobody has told then. */
    public synchronized boolean areLinesLost() {
        return areLinesLost;
    }

    /** For what prints lines. */
    public OutputStream lines() {
        return new Lines();
    }

    private synchronized void writeLine(byte[] bytes, int offset, int length) throws IOException {
        boolean isFirst = failure == null;
        try {
            write(bytes, offset, length);
        } catch (IOException e) {
            areLinesLost |= isFirst;
            throw e;
        }
    }

    @Override
    public void write(int value) throws IOException {
        write(new byte[] {(byte) value}, 0, 1);
    }

    @Override
    public synchronized void write(byte[] bytes, int offset, int length) throws IOException {
        if (failure != null) {
            throw new IOException(Failures.sentence(failure), failure);
        }
        try {
            out.write(bytes, offset, length);
        } catch (IOException e) {
            failure = e;
            throw e;
        }
    }

    @Override
    public synchronized void flush() throws IOException {
        if (failure == null) {
            out.flush();
        }
    }

    private final class Lines extends OutputStream {
        @Override
        public void write(int value) throws IOException {
            write(new byte[] {(byte) value}, 0, 1);
        }

        @Override
        public void write(byte[] bytes, int offset, int length) throws IOException {
            writeLine(bytes, offset, length);
        }

        @Override
        public void flush() throws IOException {
            Results.this.flush();
        }
    }
}
