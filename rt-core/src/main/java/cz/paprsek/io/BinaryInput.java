package cz.paprsek.io;

import java.io.BufferedInputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

/**
 * The bytes of a stranger's file, one after the other: it may end anywhere, never end, or claim anything. Nothing is kept that has been
 * read, and nothing allocated for bytes that are only promised.
 */
public final class BinaryInput implements AutoCloseable {
    private final Counted input;
    private final long size;

    /**
     * @param size how many bytes there are, or {@link Long#MAX_VALUE} if nobody knows, as of a pipe
     * @param limit after how many bytes to give up
     */
    public BinaryInput(InputStream input, long size, long limit) {
        this.input = new Counted(new BufferedInputStream(input, 1 << 16), limit);
        this.size = size;
    }

    /**
     * Refuses what the file cannot hold, before memory is taken for it.
     *
     * @param what as a sentence begins: "a picture of 3 × 4 pixels"
     * @param least how many bytes the file must have for that at the very least
     * @throws IOException if it has fewer
     */
    public void require(String what, long least) throws IOException {
        if (size < least) {
            throw new IOException(what + " does not fit into a file of " + size + " bytes: it is cut off or damaged");
        }
    }

    /** The first bytes, which are still to be read after that; fewer if there are no more. At most 64. */
    public byte[] peek(int count) throws IOException {
        input.mark(64);
        byte[] bytes = input.readNBytes(count);
        input.reset();
        return bytes;
    }

    /** Whether all bytes are read. */
    public boolean isAtEnd() throws IOException {
        return peek(1).length == 0;
    }

    /** How many bytes have been read. */
    public long position() {
        return input.count;
    }

    /** The next byte, 0–255. */
    public int u8() throws IOException {
        int read = input.read();
        if (read < 0) {
            throw cutOff();
        }
        return read;
    }

    /** Two bytes, the high one first. */
    public int u16() throws IOException {
        return u8() << 8 | u8();
    }

    /** Four bytes, the highest first, as a number without a sign. */
    public long u32() throws IOException {
        return (long) u16() << 16 | u16();
    }

    /** Four bytes, the lowest first, as a number with a sign. */
    public int littleInt() throws IOException {
        return Integer.reverseBytes((int) u32());
    }

    /** Eight bytes, the lowest first. */
    public long littleLong() throws IOException {
        return littleInt() & 0xFFFF_FFFFL | (long) littleInt() << 32;
    }

    /** The next bytes: an array that grows as they come, since many may be claimed. */
    public byte[] bytes(int count) throws IOException {
        byte[] bytes = input.readNBytes(count);
        if (bytes.length < count) {
            throw cutOff();
        }
        return bytes;
    }

    /** Fills a part of an array. */
    public void fill(byte[] into, int from, int count) throws IOException {
        if (input.readNBytes(into, from, count) < count) {
            throw cutOff();
        }
    }

    /** Leaves bytes away. */
    public void skip(long count) throws IOException {
        byte[] scratch = new byte[(int) Math.min(count, 8192)];
        for (long left = count; left > 0; left -= scratch.length) {
            fill(scratch, 0, (int) Math.min(left, scratch.length));
        }
    }

    /** Text up to a byte, which is read too. */
    public String textUpTo(int end, int longest) throws IOException {
        StringBuilder text = new StringBuilder();
        for (int c = u8(); c != end; c = u8()) {
            if (text.length() == longest) {
                throw new IOException("a line or name of more than " + longest + " characters after " + (position() - longest) + " bytes");
            }
            text.append(new String(new byte[] {(byte) c}, StandardCharsets.ISO_8859_1));
        }
        return text.toString();
    }

    /** All bytes that are left. */
    public byte[] rest() throws IOException {
        return input.readAllBytes();
    }

    /** What to throw if the file ends too early. */
    public IOException cutOff() {
        return new IOException("the file is cut off after " + position() + " bytes");
    }

    @Override
    public void close() throws IOException {
        input.close();
    }

    private static final class Counted extends FilterInputStream {
        private final long limit;
        private long count;
        private long marked;

        Counted(InputStream input, long limit) {
            super(input);
            this.limit = limit;
        }

        @Override
        public int read() throws IOException {
            int read = super.read();
            count(read < 0 ? 0 : 1);
            return read;
        }

        @Override
        public int read(byte[] into, int from, int length) throws IOException {
            int read = super.read(into, from, length);
            count(Math.max(0, read));
            return read;
        }

        @Override
        public synchronized void mark(int most) {
            super.mark(most);
            marked = count;
        }

        @Override
        public synchronized void reset() throws IOException {
            super.reset();
            count = marked;
        }

        private void count(int read) throws IOException {
            count += read;
            if (count > limit) {
                throw new IOException("this file is larger than the " + limit + " bytes that are read (java -Dpaprsek.largest-file=BYTES allows more)");
            }
        }
    }
}
