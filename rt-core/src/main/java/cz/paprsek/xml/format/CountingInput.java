package cz.paprsek.xml.format;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;

/** A stream that hears of all that is read from it. */
public abstract class CountingInput extends FilterInputStream {
    protected CountingInput(InputStream input) {
        super(input);
    }

    /** So many bytes have been read, 0 or more; what is thrown here ends the reading. */
    protected abstract void counted(int bytes) throws IOException;

    @Override
    public final int read() throws IOException {
        int read = super.read();
        counted(read < 0 ? 0 : 1);
        return read;
    }

    @Override
    public final int read(byte[] into, int offset, int length) throws IOException {
        int read = super.read(into, offset, length);
        counted(Math.max(0, read));
        return read;
    }
}
