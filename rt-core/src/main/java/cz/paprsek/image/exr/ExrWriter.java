package cz.paprsek.image.exr;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;

/**
 * Writes OpenEXR files of one part, in rows from the top.
 *
 * @source OpenEXR, File Layout (version 2 of the format)
 */
@SuppressWarnings({"EnumOrdinal", "ByteBufferBackingArray"}) // the constants stand in the order of their numbers in a file; every buffer is one that little() has allocated
public final class ExrWriter {
    static final int MAGIC = 20_000_630;
    private static final int VERSION = 2;
    private static final int LONG_NAMES = 0x400;
    private static final int SHORT_NAME = 31;

    private final int width;
    private final int height;
    private final List<ExrChannel> channels;
    private final Packing packing;
    private final Rows rows;

    /** A picture's numbers. */
    @FunctionalInterface
    public interface Rows {
        /** Sets a row of a channel. */
        void copy(String channel, int y, float[] into);
    }

    private ExrWriter(int width, int height, List<ExrChannel> channels, Packing packing, Rows rows) {
        this.width = width;
        this.height = height;
        this.channels = channels.stream().sorted(Comparator.comparing(ExrChannel::name)).toList();
        this.packing = packing;
        this.rows = rows;
    }

    /**
     * Writes a picture to a stream, which is not closed.
     *
     * @param channels in any order; each name once
     * @param isZipped whether blocks of 16 rows are compressed; without loss
     * @param texts by the names of their attributes
     */
    public static void write(int width, int height, List<ExrChannel> channels, boolean isZipped, Map<String, String> texts, Rows rows, OutputStream out)
            throws IOException {
        new ExrWriter(width, height, channels, isZipped ? Packing.ZIP : Packing.NONE, rows).write(texts, out);
    }

    private void write(Map<String, String> texts, OutputStream out) throws IOException {
        byte[] head = head(texts);
        int blocks = (height + packing.rows() - 1) / packing.rows();
        // The table of blocks comes before them, so that those that are compressed must wait for the last.
        List<byte[]> body = new ArrayList<>();
        ByteBuffer table = ByteBuffer.allocate(8 * blocks).order(ByteOrder.LITTLE_ENDIAN);
        long at = head.length + 8L * blocks;
        for (int i = 0; i < blocks; i++) {
            table.putLong(at);
            byte[] block = block(i * packing.rows());
            byte[] packed = packing == Packing.NONE ? block : Packing.zip(block);
            body.add(packed);
            at += 8 + packed.length;
        }
        out.write(head);
        out.write(table.array());
        for (int i = 0; i < blocks; i++) {
            out.write(little(8).putInt(i * packing.rows()).putInt(body.get(i).length).array());
            out.write(body.get(i));
        }
    }

    private byte[] block(int first) {
        int count = Math.min(packing.rows(), height - first);
        int pixel = channels.stream().mapToInt(channel -> channel.type().bytes()).sum();
        ByteBuffer block = ByteBuffer.allocate(count * width * pixel).order(ByteOrder.LITTLE_ENDIAN);
        float[] row = new float[width];
        for (int y = first; y < first + count; y++) {
            for (ExrChannel channel : channels) {
                rows.copy(channel.name(), y, row);
                for (float value : row) {
                    switch (channel.type()) {
                        case HALF -> block.putShort(Half.of(value));
                        case FLOAT -> block.putFloat(value);
                        case UINT -> block.putInt((int) (long) value);
                    }
                }
            }
        }
        return block.array();
    }

    private byte[] head(Map<String, String> texts) throws IOException {
        boolean hasLongNames = channels.stream().anyMatch(channel -> channel.name().length() > SHORT_NAME)
                || texts.keySet().stream().anyMatch(name -> name.length() > SHORT_NAME);
        ByteArrayOutputStream head = new ByteArrayOutputStream();
        head.write(little(8).putInt(MAGIC).putInt(VERSION | (hasLongNames ? LONG_NAMES : 0)).array());
        attribute(head, "channels", "chlist", channelList());
        attribute(head, "compression", "compression", new byte[] {(byte) packing.number()});
        byte[] window = little(16).putInt(0).putInt(0).putInt(width - 1).putInt(height - 1).array();
        attribute(head, "dataWindow", "box2i", window);
        attribute(head, "displayWindow", "box2i", window);
        attribute(head, "lineOrder", "lineOrder", new byte[1]);
        attribute(head, "pixelAspectRatio", "float", little(4).putFloat(1).array());
        attribute(head, "screenWindowCenter", "v2f", new byte[8]);
        attribute(head, "screenWindowWidth", "float", little(4).putFloat(1).array());
        for (Map.Entry<String, String> text : texts.entrySet()) {
            attribute(head, text.getKey(), "string", text.getValue().getBytes(StandardCharsets.UTF_8));
        }
        head.write(0);
        return head.toByteArray();
    }

    private byte[] channelList() throws IOException {
        ByteArrayOutputStream list = new ByteArrayOutputStream();
        for (ExrChannel channel : channels) {
            name(list, channel.name());
            list.write(little(16).putInt(channel.type().number()).putInt(0).putInt(1).putInt(1).array());
        }
        list.write(0);
        return list.toByteArray();
    }

    private static void attribute(ByteArrayOutputStream head, String name, String type, byte[] value) throws IOException {
        name(head, name);
        name(head, type);
        head.write(little(4).putInt(value.length).array());
        head.write(value);
    }

    private static void name(ByteArrayOutputStream out, String name) throws IOException {
        out.write(name.getBytes(StandardCharsets.UTF_8));
        out.write(0);
    }

    private static ByteBuffer little(int size) {
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    }
}
