package cz.paprsek.image.exr;

import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;

/**
 * How blocks of rows are compressed. Before it is compressed, every other byte of a block is
 * moved behind the others, and then each is replaced by its difference from the one before.
 *
 * @source OpenEXR, Technical Introduction, and ImfZip.cpp, ImfRle.cpp for the details it leaves out
 */
enum Packing {
    NONE(0, 1),
    RLE(1, 1),
    ZIPS(2, 1),
    ZIP(3, 16);

    private final int number;
    private final int rows;

    Packing(int number, int rows) {
        this.number = number;
        this.rows = rows;
    }

    /** The one that a file means by a number. */
    static Optional<Packing> of(int number) {
        return Arrays.stream(values()).filter(packing -> packing.number == number).findFirst();
    }

    int number() {
        return number;
    }

    /** Rows in a block. */
    int rows() {
        return rows;
    }

    /** The compressed block; the block itself if that is not smaller. */
    static byte[] zip(byte[] block) {
        byte[] prepared = prepared(block);
        Deflater deflater = new Deflater(4);
        try {
            deflater.setInput(prepared);
            deflater.finish();
            byte[] packed = new byte[block.length];
            int size = deflater.deflate(packed);
            return size < block.length && deflater.finished() ? Arrays.copyOf(packed, size) : block;
        } finally {
            deflater.end();
        }
    }

    /**
     * The block that was compressed.
     *
     * @param size its size; nothing larger is ever made
     */
    byte[] unpack(byte[] packed, int size) throws IOException {
        if (packed.length == size) {
            // What would not have become smaller was left as it was.
            return packed;
        }
        return switch (this) {
            case NONE -> throw new IOException("a block of rows should have " + size + " bytes, but has " + packed.length);
            case RLE -> restored(runs(packed, size));
            case ZIPS, ZIP -> restored(inflated(packed, size));
        };
    }

    private static byte[] inflated(byte[] packed, int size) throws IOException {
        Inflater inflater = new Inflater();
        try {
            inflater.setInput(packed);
            byte[] block = new byte[size];
            int found = inflater.inflate(block);
            if (found < size) {
                throw new IOException("a block of rows should have " + size + " bytes, but has " + found);
            }
            return block;
        } catch (DataFormatException e) {
            throw new IOException("the picture is damaged: " + e.getMessage(), e);
        } finally {
            inflater.end();
        }
    }

    /** A count from 0 says how often the byte after it is repeated once more, a negative one how many bytes follow as they are. */
    private static byte[] runs(byte[] packed, int size) throws IOException {
        byte[] block = new byte[size];
        int to = 0;
        for (int from = 0; from < packed.length;) {
            int count = packed[from++];
            int length = count < 0 ? -count : count + 1;
            if (length > size - to || from + (count < 0 ? length : 1) > packed.length) {
                throw new IOException("the picture is damaged: a run of " + length + " bytes does not fit into a block of " + size);
            }
            if (count < 0) {
                System.arraycopy(packed, from, block, to, length);
                from += length;
            } else {
                Arrays.fill(block, to, to + length, packed[from++]);
            }
            to += length;
        }
        if (to < size) {
            throw new IOException("a block of rows should have " + size + " bytes, but has " + to);
        }
        return block;
    }

    private static byte[] prepared(byte[] block) {
        byte[] prepared = new byte[block.length];
        int half = (block.length + 1) / 2;
        for (int i = 0; i < block.length; i++) {
            prepared[(i & 1) * half + i / 2] = block[i];
        }
        for (int i = block.length - 1; i > 0; i--) {
            prepared[i] = (byte) (prepared[i] - prepared[i - 1] + 128);
        }
        return prepared;
    }

    private static byte[] restored(byte[] prepared) {
        for (int i = 1; i < prepared.length; i++) {
            prepared[i] = (byte) (prepared[i] + prepared[i - 1] - 128);
        }
        byte[] block = new byte[prepared.length];
        int half = (block.length + 1) / 2;
        for (int i = 0; i < block.length; i++) {
            block[i] = prepared[(i & 1) * half + i / 2];
        }
        return block;
    }
}
