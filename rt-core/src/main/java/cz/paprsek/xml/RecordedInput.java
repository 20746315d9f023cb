package cz.paprsek.xml;

import java.io.ByteArrayOutputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;

/** A stream that keeps all that has been read from it. What is refused is refused before more of it is kept. */
final class RecordedInput extends FilterInputStream {
    private final ByteArrayOutputStream kept = new ByteArrayOutputStream();

    RecordedInput(InputStream input) {
        super(input);
    }

    byte[] bytes() {
        return kept.toByteArray();
    }

    @Override
    public int read() throws IOException {
        int read = super.read();
        if (read >= 0) {
            kept.write(read);
        }
        return read;
    }

    @Override
    public int read(byte[] into, int offset, int length) throws IOException {
        int read = super.read(into, offset, length);
        if (read > 0) {
            kept.write(into, offset, read);
        }
        return read;
    }
}
