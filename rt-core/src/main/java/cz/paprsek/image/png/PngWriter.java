package cz.paprsek.image.png;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.zip.CRC32;

/**
 * Writes PNG files on all processors. A picture is cut into stripes whose height follows from its width alone, so that the file is the same on
 * any number of them.
 *
 * @source PNG Specification (Third Edition); RFC 1950 and 1951 for the stream of compressed rows
 */
public final class PngWriter {
    static final int LEVEL = 5;
    /** Deflate with a window of 32 KiB, at a quick level. */
    private static final byte[] STREAM_HEAD = {0x78, 0x5E};
    private static final byte[] PERCEPTUAL = {0};

    private final PngHead head;
    private final OutputStream out;

    /** A picture's samples, in the order of the file, the high byte first. Several threads ask at once. */
    @FunctionalInterface
    public interface Rows {
        /** Copies the bytes of a row into an array, from an index on. */
        void copy(int y, byte[] into, int at);
    }

    /** Takes compressed pixels. */
    @FunctionalInterface
    interface Data {
        void take(byte[] bytes, int size) throws IOException;
    }

    PngWriter(PngHead head, OutputStream out) {
        this.head = head;
        this.out = out;
    }

    /**
     * Writes a picture of sRGB-encoded samples to a stream, which is not closed.
     *
     * @param texts by keywords, as Title, of 1 to 79 letters
     */
    public static void write(Map<String, String> texts, Stripes stripes, OutputStream out) throws IOException {
        PngWriter writer = new PngWriter(stripes.head(), out);
        writer.start(texts);
        pixels(stripes, writer::data);
        writer.chunk("IEND", new byte[0]);
    }

    /** Writes all that comes before pixels. */
    void start(Map<String, String> texts) throws IOException {
        out.write(PngHead.SIGNATURE);
        chunk("IHDR", ByteBuffer.allocate(13).putInt(head.width()).putInt(head.height())
                .put((byte) head.bits()).put((byte) head.color()).put(new byte[3]).array());
        chunk("sRGB", PERCEPTUAL);
        for (Map.Entry<String, String> text : texts.entrySet()) {
            text(text.getKey(), text.getValue());
        }
    }

    /** The pixels of a picture that is the only one, or the first. */
    void data(byte[] bytes, int size) throws IOException {
        chunk("IDAT", bytes, size);
    }

    /** As Latin-1 where that has all the letters, which more programs can read. */
    private void text(String keyword, String text) throws IOException {
        boolean isLatin = StandardCharsets.ISO_8859_1.newEncoder().canEncode(text);
        if (isLatin) {
            chunk("tEXt", (keyword + '\0' + text).getBytes(StandardCharsets.ISO_8859_1));
        } else {
            // Not compressed, in no language said, the keyword not translated.
            chunk("iTXt", (keyword + "\0\0\0\0\0" + text).getBytes(StandardCharsets.UTF_8));
        }
    }

    void pixels(Rows rows, Data data) throws IOException {
        try (Stripes stripes = new Stripes(head, rows)) {
            pixels(stripes, data);
        }
    }

    private static void pixels(Stripes stripes, Data data) throws IOException {
        data.take(STREAM_HEAD, STREAM_HEAD.length);
        int checksum = 1;
        while (stripes.hasNext()) {
            Stripe stripe = stripes.next();
            checksum = stripe.checksumAfter(checksum);
            data.take(stripe.compressed(), stripe.size());
        }
        data.take(ByteBuffer.allocate(Integer.BYTES).putInt(checksum).array(), Integer.BYTES);
    }

    void chunk(String type, byte[] content) throws IOException {
        chunk(type, content, content.length);
    }

    private void chunk(String type, byte[] content, int size) throws IOException {
        byte[] frame = ByteBuffer.allocate(8).putInt(size).put(type.getBytes(StandardCharsets.US_ASCII)).array();
        CRC32 crc = new CRC32();
        crc.update(frame, 4, 4);
        crc.update(content, 0, size);
        out.write(frame);
        out.write(content, 0, size);
        out.write(ByteBuffer.allocate(Integer.BYTES).putInt((int) crc.getValue()).array());
    }
}
