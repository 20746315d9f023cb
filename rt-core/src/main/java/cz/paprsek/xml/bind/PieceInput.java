package cz.paprsek.xml.bind;

import cz.paprsek.xml.format.CountingInput;
import java.io.IOException;
import java.io.InputStream;

/** A stream that a parser must make something of: it ends with an error if so much is read without a tag or text being found in it. */
final class PieceInput extends CountingInput {
    /** In bytes. The parser keeps what it is in the middle of, so this bounds its memory. */
    private static final int LONGEST = 1 << 23;

    private int length;

    PieceInput(InputStream input) {
        super(input);
    }

    /** The parser has found something. */
    void found() {
        length = 0;
    }

    @Override
    protected void counted(int read) throws TooLong {
        length += read;
        if (length > LONGEST) {
            throw new TooLong();
        }
    }

    /** There is a comment, a value or a name beyond all measure. */
    static final class TooLong extends IOException {
        private static final long serialVersionUID = 1;

        TooLong() {
            super("a comment, value or name is longer than " + LONGEST + " bytes");
        }
    }
}
