package cz.paprsek.image.png;

import cz.paprsek.io.BinaryInput;
import cz.paprsek.io.PlainText;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.List;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;
import java.util.zip.ZipException;

/**
 * Reads PNG files of every kind: all depths, colour types and both orders of rows, with opacity.
 *
 * @source PNG Specification (Third Edition)
 */
public final class PngReader {
    /** Interlaced pictures come in seven parts: first column and row of each, and the steps to the next. */
    private static final int[][] PASSES = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
    private static final int[][] WHOLE = {{0, 0, 1, 1}};
    /** By colour type. */
    private static final List<List<Integer>> DEPTHS =
            List.of(List.of(1, 2, 4, 8, 16), List.of(), List.of(8, 16), List.of(1, 2, 4, 8), List.of(8, 16), List.of(), List.of(8, 16));
    /** No compressor shrinks anything further than that. */
    private static final int MOST_COMPRESSION = 1032;
    private static final Filter[] FILTERS = Filter.values();

    private final Chunks chunks;
    private final PngHead head;
    private final boolean isInterlaced;
    private byte[] palette = {};
    /** Opacity of the palette's colours, or else the one colour that is transparent. */
    private byte[] transparent = {};
    private long gamma;
    private boolean isSrgb;

    /** Takes the pixels as they come. */
    @FunctionalInterface
    public interface Sink {
        /**
         * Some pixels of a row: columns x, x + step, …
         *
         * @param rgb three samples of each pixel, 0 to {@link PngReader#last}
         * @param opacity one sample of each pixel, as above; none at all if the file has no opacity
         */
        void pixels(int y, int x, int step, int count, int[] rgb, int[] opacity);
    }

    private PngReader(BinaryInput input) throws IOException {
        input.skip(PngHead.SIGNATURE.length);
        chunks = new Chunks(input);
        if (!chunks.next().equals("IHDR") || chunks.length() != 13) {
            throw new IOException("a PNG begins with its size, but here is " + chunks.shown());
        }
        byte[] bytes = chunks.content(13);
        int width = number(bytes, 0);
        int height = number(bytes, 4);
        int color = bytes[9];
        if (width < 1 || height < 1) {
            throw new IOException("a picture cannot have " + (width & 0xFFFF_FFFFL) + " × " + (height & 0xFFFF_FFFFL) + " pixels");
        }
        if (color < 0 || color >= DEPTHS.size() || !DEPTHS.get(color).contains((int) bytes[8])) {
            throw new IOException("there are no PNGs of colour type " + color + " with " + bytes[8] + " bits per sample");
        }
        if (bytes[10] != 0 || bytes[11] != 0 || bytes[12] < 0 || bytes[12] > 1) {
            throw new IOException("a PNG of an unknown kind: compression " + bytes[10] + ", filter " + bytes[11] + ", interlace " + bytes[12]);
        }
        head = new PngHead(width, height, bytes[8], color);
        isInterlaced = bytes[12] == 1;
        input.require("a picture of " + width + " × " + height + " pixels", (long) height * head.rowBytes(width) / MOST_COMPRESSION);
        readUpToPixels();
    }

    /** Whether a file begins as a PNG does. */
    public static boolean canRead(byte[] start) {
        return start.length >= 8 && Arrays.equals(start, 0, 8, PngHead.SIGNATURE, 0, 8);
    }

    /**
     * Reads everything before the pixels.
     *
     * @throws IOException saying in one line what is wrong with the file
     */
    public static PngReader of(BinaryInput input) throws IOException {
        return new PngReader(input);
    }

    public PngHead head() {
        return head;
    }

    /** The sample that stands for the most light. */
    public int last() {
        return head.color() == 3 ? 255 : (1 << head.bits()) - 1;
    }

    /** Whether there is brightness only. */
    public boolean isGrey() {
        return head.color() == 0 || head.color() == 4;
    }

    /** Whether some pixels may be transparent. */
    public boolean hasOpacity() {
        return head.color() >= 4 || transparent.length > 0;
    }

    /** 100 000 times the power that turns light into samples; 0 if the samples are sRGB-encoded or the file does not say. */
    public long gamma() {
        return isSrgb ? 0 : gamma;
    }

    /**
     * Reads the pixels; once only.
     *
     * @throws IOException saying in one line what is wrong with the file
     */
    public void read(Sink sink) throws IOException {
        Inflater inflater = new Inflater();
        try (InputStream stream = new InflaterInputStream(chunks.pixels(), inflater, 1 << 16)) {
            for (int[] pass : isInterlaced ? PASSES : WHOLE) {
                read(stream, pass, sink);
            }
            // Lets the stream check the checksum at its end. What may lie behind it is none of the picture.
            stream.read();
        } catch (ZipException e) {
            throw new IOException("the picture is damaged: " + e.getMessage(), e);
        } catch (EOFException e) {
            throw new IOException("the picture is cut off: its compressed pixels end too early", e);
        } finally {
            inflater.end();
        }
    }

    private void read(InputStream stream, int[] pass, Sink sink) throws IOException {
        int columns = (head.width() - pass[0] + pass[2] - 1) / pass[2];
        int pixel = head.pixelBytes();
        if (columns < 1) {
            return;
        }
        int length = head.rowBytes(columns);
        byte[] above = new byte[pixel + length];
        byte[] row = new byte[pixel + length];
        int[] rgb = new int[3 * columns];
        int[] opacity = new int[hasOpacity() ? columns : 0];
        for (int y = pass[1]; y < head.height(); y += pass[3]) {
            int filter = stream.read();
            if (filter >= FILTERS.length) {
                throw new IOException("the picture is damaged: row " + y + " has filter " + filter + ", and there are only " + FILTERS.length);
            }
            if (filter < 0 || stream.readNBytes(row, pixel, length) < length) {
                throw new IOException("the picture is cut off: there are no more pixels in row " + y + " of " + head.height());
            }
            FILTERS[filter].undo(row, above, pixel);
            unpack(row, pixel, columns, rgb);
            for (int x = 0; x < opacity.length; x++) {
                opacity[x] = opacity(row, pixel, x, rgb);
            }
            sink.pixels(y, pass[0], pass[2], columns, rgb, opacity);
            byte[] swap = above;
            above = row;
            row = swap;
        }
    }

    private void unpack(byte[] row, int from, int columns, int[] rgb) throws IOException {
        int channels = head.channels();
        boolean hasColors = channels > 2;
        for (int x = 0; x < columns; x++) {
            int first = sample(row, from, x * channels);
            if (head.color() == 3) {
                if (3 * first >= palette.length) {
                    throw new IOException("the picture is damaged: it has color " + first + " of a palette of " + palette.length / 3);
                }
                for (int c = 0; c < 3; c++) {
                    rgb[3 * x + c] = palette[3 * first + c] & 0xFF;
                }
            } else {
                rgb[3 * x] = first;
                rgb[3 * x + 1] = hasColors ? sample(row, from, x * channels + 1) : first;
                rgb[3 * x + 2] = hasColors ? sample(row, from, x * channels + 2) : first;
            }
        }
    }

    private int opacity(byte[] row, int from, int x, int[] rgb) {
        if (head.color() >= 4) {
            return sample(row, from, (x + 1) * head.channels() - 1);
        }
        if (head.color() == 3) {
            int index = sample(row, from, x);
            return index < transparent.length ? transparent[index] & 0xFF : last();
        }
        for (int c = 0; c < head.channels(); c++) {
            int key = (transparent[2 * c] & 0xFF) << 8 | (transparent[2 * c + 1] & 0xFF);
            if (rgb[3 * x + c] != key) {
                return last();
            }
        }
        return 0;
    }

    private int sample(byte[] row, int from, int index) {
        return switch (head.bits()) {
            case 16 -> (row[from + 2 * index] & 0xFF) << 8 | (row[from + 2 * index + 1] & 0xFF);
            case 8 -> row[from + index] & 0xFF;
            default -> {
                int bit = index * head.bits();
                int shift = 8 - head.bits() - bit % 8;
                yield (row[from + bit / 8] >> shift) & ((1 << head.bits()) - 1);
            }
        };
    }

    private void readUpToPixels() throws IOException {
        for (String type = chunks.next(); !type.equals("IDAT"); type = chunks.next()) {
            switch (type) {
                case "PLTE" -> palette = chunks.content(3 * 256);
                case "tRNS" -> transparent = chunks.content(256);
                case "gAMA" -> gamma = chunks.length() == 4 ? number(chunks.content(4), 0) : 0;
                case "sRGB" -> isSrgb = true;
                case "IEND" -> throw new IOException("a PNG without pixels");
                default -> {
                    if (Character.isUpperCase(type.charAt(0))) {
                        throw new IOException("the PNG has a part that must be understood and is not known: " + PlainText.of(type, 4));
                    }
                }
            }
        }
        if (head.color() == 3 && (palette.length == 0 || palette.length % 3 != 0)) {
            throw new IOException("the picture is damaged: its palette has " + palette.length + " bytes");
        }
        // What cannot be opacity is none.
        if (head.color() >= 4 || (head.color() != 3 && transparent.length != 2 * head.channels())) {
            transparent = new byte[0];
        }
    }

    private static int number(byte[] bytes, int at) {
        return (bytes[at] & 0xFF) << 24 | (bytes[at + 1] & 0xFF) << 16 | (bytes[at + 2] & 0xFF) << 8 | (bytes[at + 3] & 0xFF);
    }
}
