package cz.paprsek.xml;

import cz.paprsek.xml.format.CountingInput;
import java.io.IOException;
import java.io.InputStream;

/** A stream that ends with an error after so many bytes: an endless one must not fill the memory. */
final class LimitedInput extends CountingInput {
    private final String file;
    private final long limit;
    private long left;

    LimitedInput(InputStream input, String file, long limit) {
        super(input);
        this.file = file;
        this.limit = limit;
        left = limit;
    }

    @Override
    protected void counted(int read) throws IOException {
        left -= read;
        if (left < 0) {
            throw new IOException(file + ": this file is larger than the " + limit + " bytes that a scene file may have (java -Dpaprsek.largest-file=BYTES allows more)");
        }
    }
}
