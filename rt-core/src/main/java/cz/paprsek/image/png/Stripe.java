package cz.paprsek.image.png;

import java.util.Arrays;
import java.util.concurrent.Callable;
import java.util.zip.Adler32;
import java.util.zip.Deflater;

/** Some rows of a picture, filtered and compressed by themselves, so that several threads can be at work on one file. */
final class Stripe implements Callable<Stripe> {
    /** Not the average: of rendered pictures it makes none smaller. */
    private static final Filter[] FILTERS = {Filter.NONE, Filter.SUB, Filter.UP, Filter.PAETH};
    /** How many bytes are looked at to choose a filter, of how many. */
    private static final int SAMPLE = 64;
    private static final int SAMPLE_EVERY = 256;
    /** How many rows are compressed both ways to find out whether to filter. */
    private static final int SAMPLE_ROWS = 8;

    private final PngHead head;
    private final PngWriter.Rows rows;
    private final int from;
    private final int to;
    /** Bytes from a row to the next: the number of its filter and its samples. */
    private final int stride;
    private byte[] compressed = {};
    private int size;
    private int checksum;

    /**
     * @param from the first row
     * @param to the row after the last
     */
    Stripe(PngHead head, PngWriter.Rows rows, int from, int to) {
        this.head = head;
        this.rows = rows;
        this.from = from;
        this.to = to;
        stride = 1 + head.rowBytes(head.width());
    }

    /** Compresses the stripe. */
    @Override
    public Stripe call() {
        byte[] bytes = chosen(plain());
        Adler32 adler = new Adler32();
        adler.update(bytes);
        checksum = (int) adler.getValue();
        Deflater deflater = new Deflater(PngWriter.LEVEL, true);
        try {
            deflater.setInput(bytes);
            compress(deflater, bytes.length);
        } finally {
            deflater.end();
        }
        return this;
    }

    byte[] compressed() {
        return compressed;
    }

    /** How many bytes of {@link #compressed} count. */
    int size() {
        return size;
    }

    /** The Adler-32 checksum of all stripes up to this, given that of those before. */
    int checksumAfter(int before) {
        long prime = 65_521;
        long length = (long) (to - from) * stride % prime;
        long low = (before & 0xFFFF) + (checksum & 0xFFFF) + prime - 1;
        long high = (before >>> 16) + (checksum >>> 16) + length * ((before & 0xFFFF) + prime - 1);
        return (int) (high % prime << 16 | low % prime);
    }

    private void compress(Deflater deflater, int length) {
        boolean isLast = to == head.height();
        if (isLast) {
            deflater.finish();
        }
        compressed = new byte[length / 4 + 64];
        while (true) {
            size += deflater.deflate(compressed, size, compressed.length - size, isLast ? Deflater.NO_FLUSH : Deflater.SYNC_FLUSH);
            if (size < compressed.length) {
                return;
            }
            compressed = Arrays.copyOf(compressed, 2 * size);
        }
    }

    /** All rows unfiltered. */
    private byte[] plain() {
        byte[] all = new byte[(to - from) * stride];
        for (int y = from; y < to; y++) {
            rows.copy(y, all, (y - from) * stride + 1);
        }
        return all;
    }

    /**
     * The rows filtered or not, whichever makes some rows in the middle of them smaller. Flat areas and sharp edges, of which many rendered
     * pictures consist, are best left alone; noise and gentle slopes are not.
     */
    private byte[] chosen(byte[] plain) {
        int sample = Math.min(to - from, SAMPLE_ROWS);
        int start = (to - from - sample) / 2;
        byte[] some = Arrays.copyOfRange(plain, start * stride, (start + sample) * stride);
        return size(filtered(plain, start, start + sample)) < size(some) ? filtered(plain, 0, to - from) : plain;
    }

    /** How large bytes become when they are compressed quickly. */
    private static int size(byte[] bytes) {
        Deflater deflater = new Deflater(Deflater.BEST_SPEED, true);
        try {
            deflater.setInput(bytes);
            deflater.finish();
            byte[] scratch = new byte[1 << 14];
            while (!deflater.finished()) {
                deflater.deflate(scratch);
            }
            return deflater.getTotalOut();
        } finally {
            deflater.end();
        }
    }

    /** Rows of the stripe, each in the filter that leaves the least to say. */
    @SuppressWarnings("EnumOrdinal") // the order of the filters is that of their numbers in a file
    private byte[] filtered(byte[] plain, int first, int end) {
        int pixel = head.pixelBytes();
        byte[] all = new byte[(end - first) * stride];
        byte[] above = new byte[pixel + stride - 1];
        byte[] row = new byte[pixel + stride - 1];
        byte[] filtered = new byte[stride - 1];
        if (first > 0) {
            System.arraycopy(plain, (first - 1) * stride + 1, above, pixel, stride - 1);
        } else if (from > 0) {
            rows.copy(from - 1, above, pixel);
        }
        for (int y = first; y < end; y++) {
            System.arraycopy(plain, y * stride + 1, row, pixel, stride - 1);
            Filter best = best(row, above, pixel, filtered);
            best.apply(row, above, pixel, pixel, row.length, filtered);
            int at = (y - first) * stride;
            all[at] = (byte) best.number();
            System.arraycopy(filtered, 0, all, at + 1, stride - 1);
            byte[] swap = above;
            above = row;
            row = swap;
        }
        return all;
    }

    /** The filter that leaves the least to say: the least sum of differences, taken as numbers around 0, in samples of the row. */
    private static Filter best(byte[] row, byte[] above, int pixel, byte[] scratch) {
        Filter best = Filter.NONE;
        int least = Integer.MAX_VALUE;
        for (Filter filter : FILTERS) {
            int sum = 0;
            for (int start = pixel; start < row.length; start += SAMPLE_EVERY) {
                int end = Math.min(row.length, start + SAMPLE);
                filter.apply(row, above, pixel, start, end, scratch);
                for (int i = start - pixel; i < end - pixel; i++) {
                    sum += Math.abs(scratch[i]);
                }
            }
            if (sum < least) {
                least = sum;
                best = filter;
            }
        }
        return best;
    }
}
