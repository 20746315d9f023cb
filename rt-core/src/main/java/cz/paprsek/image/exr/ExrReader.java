package cz.paprsek.image.exr;

import cz.paprsek.io.BinaryInput;
import cz.paprsek.io.PlainText;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads OpenEXR files of one part in rows, compressed without loss by runs or ZIP. Other kinds are refused by their names.
 *
 * @source OpenEXR, File Layout
 */
public final class ExrReader {
    private static final String[] PACKINGS = {"none", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB"};
    private static final int LONGEST_NAME = 255;
    private static final int LONGEST_ATTRIBUTE = 1 << 24;
    private static final int MOST_ATTRIBUTES = 10_000;
    private static final int MOST_CHANNELS = 1_000;
    /** No compressor that is known here shrinks anything further than that. */
    private static final int MOST_COMPRESSION = 1032;
    private static final int TILED = 0x200;
    private static final int DEEP = 0x800;
    private static final int PARTS = 0x1000;

    private final BinaryInput input;
    private final List<ExrChannel> channels = new ArrayList<>();
    private final Map<String, String> texts = new HashMap<>();
    private Packing packing = Packing.NONE;
    private int left;
    private int top;
    private long width;
    private long height;

    /** Takes the numbers as they come. */
    @FunctionalInterface
    public interface Sink {
        /**
         * A row of a channel.
         *
         * @param channel its place among the {@link ExrReader#channels()}
         */
        void row(int channel, int y, float[] values);
    }

    private ExrReader(BinaryInput input) throws IOException {
        this.input = input;
        input.skip(4);
        int version = input.littleInt();
        refuse((version & 0xFF) != 2, "it is of version " + (version & 0xFF) + " of the format");
        refuse((version & TILED) != 0, "its pixels lie in tiles");
        refuse((version & DEEP) != 0, "its pixels have many depths");
        refuse((version & PARTS) != 0, "it has several parts");
        readHead();
        if (channels.isEmpty() || width == 0) {
            throw new IOException("the picture is damaged: its head has no channels or no size");
        }
        input.require("a picture of " + width + " × " + height + " pixels", width * height / MOST_COMPRESSION * pixelBytes());
    }

    /** Whether a file begins as an OpenEXR file does. */
    public static boolean canRead(byte[] start) {
        return start.length >= 4 && ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN).getInt() == ExrWriter.MAGIC;
    }

    /**
     * Reads everything before the pixels.
     *
     * @throws IOException saying in one line what is wrong with the file
     */
    public static ExrReader of(BinaryInput input) throws IOException {
        return new ExrReader(input);
    }

    public long width() {
        return width;
    }

    public long height() {
        return height;
    }

    /** The channels, in the order of the file. */
    public List<ExrChannel> channels() {
        return List.copyOf(channels);
    }

    /** Attributes that are texts. */
    public Map<String, String> texts() {
        return Map.copyOf(texts);
    }

    /**
     * Reads the pixels; once only.
     *
     * @throws IOException saying in one line what is wrong with the file
     */
    public void read(Sink sink) throws IOException {
        int blocks = (int) ((height + packing.rows() - 1) / packing.rows());
        // Where each block begins. They follow one another, and each says which it is: that is enough.
        input.skip(8L * blocks);
        boolean[] isKnown = new boolean[blocks];
        for (int i = 0; i < blocks; i++) {
            long y = (long) input.littleInt() - top;
            if (y < 0 || y >= height || y % packing.rows() != 0 || isKnown[(int) y / packing.rows()]) {
                throw new IOException("the picture is damaged: before byte " + input.position() + " is a block of row " + y
                        + ", which there is not, or which was there before");
            }
            isKnown[(int) y / packing.rows()] = true;
            int count = (int) Math.min(packing.rows(), height - y);
            long size = count * width * pixelBytes();
            int packed = input.littleInt();
            if (packed < 0 || packed > size || size > Integer.MAX_VALUE - 8) {
                throw new IOException("the picture is damaged: a block of " + size + " bytes is compressed to " + packed);
            }
            unfold(ByteBuffer.wrap(packing.unpack(input.bytes(packed), (int) size)).order(ByteOrder.LITTLE_ENDIAN), (int) y, count, sink);
        }
    }

    private void unfold(ByteBuffer block, int first, int count, Sink sink) {
        float[] row = new float[(int) width];
        for (int y = first; y < first + count; y++) {
            for (int c = 0; c < channels.size(); c++) {
                for (int x = 0; x < row.length; x++) {
                    row[x] = switch (channels.get(c).type()) {
                        case HALF -> Half.toFloat(block.getShort());
                        case FLOAT -> block.getFloat();
                        case UINT -> block.getInt() & 0xFFFF_FFFFL;
                    };
                }
                sink.row(c, y, row);
            }
        }
    }

    private int pixelBytes() {
        return channels.stream().mapToInt(channel -> channel.type().bytes()).sum();
    }

    private void readHead() throws IOException {
        for (int i = 0; i < MOST_ATTRIBUTES; i++) {
            String name = input.textUpTo(0, LONGEST_NAME);
            if (name.isEmpty()) {
                return;
            }
            String type = input.textUpTo(0, LONGEST_NAME);
            int size = input.littleInt();
            if (size < 0 || size > LONGEST_ATTRIBUTE) {
                throw new IOException("the picture is damaged: its attribute " + PlainText.of(name, 40) + " has " + size + " bytes");
            }
            heed(name, type, input.bytes(size));
        }
        throw new IOException("the head has more than " + MOST_ATTRIBUTES + " attributes");
    }

    private void heed(String name, String type, byte[] value) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap(value).order(ByteOrder.LITTLE_ENDIAN);
        switch (name) {
            case "channels" -> readChannels(bytes);
            case "compression" -> {
                requireSize(name, value, 1);
                int number = value[0] & 0xFF;
                Optional<Packing> known = Packing.of(number);
                refuse(known.isEmpty(), "it is compressed by "
                        + (number < PACKINGS.length ? PACKINGS[number] : "method " + number) + "; none, RLE, ZIPS and ZIP can be read");
                packing = known.orElseThrow();
            }
            case "dataWindow" -> {
                requireSize(name, value, 16);
                left = bytes.getInt();
                top = bytes.getInt();
                width = (long) bytes.getInt() - left + 1;
                height = (long) bytes.getInt() - top + 1;
                if (width < 1 || height < 1 || width > Integer.MAX_VALUE || height > Integer.MAX_VALUE) {
                    throw new IOException("a picture cannot have " + width + " × " + height + " pixels");
                }
            }
            default -> {
                if (type.equals("string")) {
                    texts.put(name, new String(value, StandardCharsets.UTF_8));
                }
            }
        }
    }

    private void readChannels(ByteBuffer bytes) throws IOException {
        channels.clear();
        while (true) {
            StringBuilder name = new StringBuilder();
            for (int c = next(bytes); c != 0; c = next(bytes)) {
                name.append((char) c);
            }
            if (name.length() == 0) {
                return;
            }
            if (bytes.remaining() < 16 || channels.size() == MOST_CHANNELS) {
                throw new IOException("the picture is damaged: its list of channels is cut off or longer than " + MOST_CHANNELS);
            }
            int type = bytes.getInt();
            bytes.getInt();
            int stepX = bytes.getInt();
            int stepY = bytes.getInt();
            refuse(stepX != 1 || stepY != 1, "its channel " + PlainText.of(name.toString(), 40) + " has fewer pixels than the picture");
            Optional<ExrType> known = ExrType.of(type);
            if (known.isEmpty()) {
                throw new IOException("the picture is damaged: its channel " + PlainText.of(name.toString(), 40) + " is of type " + type);
            }
            channels.add(new ExrChannel(name.toString(), known.get()));
        }
    }

    private static int next(ByteBuffer bytes) throws IOException {
        if (!bytes.hasRemaining()) {
            throw new IOException("the picture is damaged: its list of channels is cut off");
        }
        return bytes.get() & 0xFF;
    }

    private static void requireSize(String name, byte[] value, int size) throws IOException {
        if (value.length != size) {
            throw new IOException("the picture is damaged: its attribute " + name + " should have " + size + " bytes, but has " + value.length);
        }
    }

    private static void refuse(boolean isRefused, String sentence) throws IOException {
        if (isRefused) {
            throw new IOException("this kind of OpenEXR file cannot be read: " + sentence);
        }
    }
}
