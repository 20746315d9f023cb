package cz.paprsek.image.png;

import cz.paprsek.io.BinaryInput;
import cz.paprsek.io.PlainText;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;

/** The parts that a PNG file is made of, one after the other. The checksums of those that are looked at are checked. */
final class Chunks {
    private final BinaryInput input;
    private final CRC32 checksum = new CRC32();
    private String type = "";
    private long length;
    private long left;
    private boolean isChecked = true;

    Chunks(BinaryInput input) {
        this.input = input;
    }

    /** Passes over what is left of this part and goes to the next; gives its type. */
    String next() throws IOException {
        if (!isChecked) {
            input.skip(left + Integer.BYTES);
        }
        length = input.u32();
        left = length;
        byte[] letters = input.bytes(4);
        type = new String(letters, StandardCharsets.ISO_8859_1);
        for (byte letter : letters) {
            if (!((letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z'))) {
                throw new IOException("the picture is damaged: after " + (input.position() - 8) + " bytes should be a part with a name of four letters, but is "
                        + PlainText.of(type, 4));
            }
        }
        if (length > Integer.MAX_VALUE) {
            throw new IOException("the picture is damaged: it has " + shown() + " of " + length + " bytes");
        }
        checksum.reset();
        checksum.update(letters);
        isChecked = false;
        return type;
    }

    long length() {
        return length;
    }

    String shown() {
        return "a part " + type;
    }

    /** All of this part. */
    byte[] content(int longest) throws IOException {
        if (length > longest) {
            throw new IOException("the picture is damaged: it has " + shown() + " of " + length + " bytes, and there can be " + longest);
        }
        byte[] bytes = input.bytes((int) length);
        checksum.update(bytes);
        left = 0;
        check();
        return bytes;
    }

    /** The content of this part and those of the same type behind it, as one stream. */
    InputStream pixels() {
        return new InputStream() {
            private final byte[] single = new byte[1];

            @Override
            public int read() throws IOException {
                return read(single, 0, 1) < 0 ? -1 : single[0] & 0xFF;
            }

            @Override
            public int read(byte[] into, int from, int count) throws IOException {
                while (left == 0 && type.equals("IDAT")) {
                    check();
                    next();
                }
                if (!type.equals("IDAT")) {
                    return -1;
                }
                int size = (int) Math.min(count, left);
                input.fill(into, from, size);
                checksum.update(into, from, size);
                left -= size;
                return size;
            }
        };
    }

    private void check() throws IOException {
        isChecked = true;
        if (input.u32() != checksum.getValue()) {
            throw new IOException("the picture is damaged: the checksum of " + shown() + " before byte " + input.position() + " is wrong");
        }
    }
}
