package cz.paprsek.io;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/**
 * The bytes of a stranger's file, one after the other: it may end anywhere, never end, or claim anything. Nothing is kept that has been
 * read, and nothing allocated for bytes that are only promised.
 */
public final class BinaryInput implements AutoCloseable {
    private static final int BUFFER = 1 << 16;
    private static final int PIECE = 1 << 20;

    private final InputStream input;
    private final long size;
    private final long limit;
    // Not a BufferedInputStream: that asks how much is available, which pipes do not answer.
    private final byte[] buffer = new byte[BUFFER];
    private int at;
    private int end;
    private long read;

    /**
     * @param size how many bytes there are, or {@link Long#MAX_VALUE} if nobody knows, as of a pipe
     * @param limit after how many bytes to give up
     */
    public BinaryInput(InputStream input, long size, long limit) {
        this.input = input;
        this.size = size;
        this.limit = limit;
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

    /** The next bytes, which are still to be read after that; fewer if there are no more. At most 64. */
    public byte[] peek(int count) throws IOException {
        while (end - at < count && refill()) {
            // A read may bring less than was asked for.
        }
        return Arrays.copyOfRange(buffer, at, Math.min(end, at + count));
    }

    /** How many bytes have been read. */
    public long position() {
        return read - (end - at);
    }

    /** The next byte, 0–255. */
    public int u8() throws IOException {
        if (at == end && !refill()) {
            throw cutOff();
        }
        return buffer[at++] & 0xFF;
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

    /** The next bytes: an array that grows as they come, since many may be claimed. */
    public byte[] bytes(int count) throws IOException {
        byte[] bytes = new byte[Math.min(count, PIECE)];
        fill(bytes, 0, bytes.length);
        for (int known = bytes.length; known < count; known = bytes.length) {
            bytes = Arrays.copyOf(bytes, (int) Math.min(count, 2L * known));
            fill(bytes, known, bytes.length - known);
        }
        return bytes;
    }

    /** Fills a part of an array. */
    public void fill(byte[] into, int from, int count) throws IOException {
        for (int done = 0; done < count;) {
            if (at == end && !refill()) {
                throw cutOff();
            }
            int piece = Math.min(count - done, end - at);
            System.arraycopy(buffer, at, into, from + done, piece);
            at += piece;
            done += piece;
        }
    }

    /** Leaves bytes away. */
    public void skip(long count) throws IOException {
        for (long left = count; left > 0;) {
            if (at == end && !refill()) {
                throw cutOff();
            }
            int piece = (int) Math.min(left, end - at);
            at += piece;
            left -= piece;
        }
    }

    /** Text up to a byte, which is read too. */
    public String textUpTo(int last, int longest) throws IOException {
        StringBuilder text = new StringBuilder();
        for (int c = u8(); c != last; c = u8()) {
            if (text.length() == longest) {
                throw new IOException("a line or name of more than " + longest + " characters after " + (position() - longest) + " bytes");
            }
            text.append((char) c);
        }
        return text.toString();
    }

    /** All bytes that are left. */
    public byte[] rest() throws IOException {
        ByteArrayOutputStream rest = new ByteArrayOutputStream();
        do {
            rest.write(buffer, at, end - at);
            at = end;
        } while (refill());
        return rest.toByteArray();
    }

    /** What to throw if the file ends too early. */
    private IOException cutOff() {
        return new IOException("the file is cut off after " + position() + " bytes");
    }

    /** Gets more bytes behind those that are still to be read; false if there are none. */
    private boolean refill() throws IOException {
        System.arraycopy(buffer, at, buffer, 0, end - at);
        end -= at;
        at = 0;
        int more = input.read(buffer, end, buffer.length - end);
        if (more < 0) {
            return false;
        }
        end += more;
        read += more;
        if (read > limit) {
            throw new IOException("this file is larger than the " + limit + " bytes that are read (java -Dpaprsek.largest-file=BYTES allows more)");
        }
        return true;
    }

    @Override
    public void close() throws IOException {
        input.close();
    }
}
