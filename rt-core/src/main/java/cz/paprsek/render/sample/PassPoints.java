package cz.paprsek.render.sample;

import java.util.Arrays;

/**
 * Scratch of one worker: the points of a whole pass of a pixel, by dimension. Samples of a pass that go alike ask for the same dimensions: once a second one
 * asks, the points of all are made together, step by step in plain loops, which the JVM makes vectors of; that takes as long as a few by themselves.
 */
final class PassPoints {
    /** In place of where a point is: it is to be made by itself. */
    static final int ALONE = -1;

    private static final int PASS = PassSums.PASS;
    private static final int LOG = 8;
    /** Spreads dimensions over the entries: 2³² times the golden ratio. */
    private static final int SPREAD = 0x9E37_79B1;

    /** Of each entry the dimension, and the pass in which it was asked for: negated if but once. */
    private final int[] dimensions = new int[1 << LOG];
    private final int[] passes = new int[1 << LOG];
    private final int[] us = new int[PASS << LOG];
    private final int[] vs = new int[PASS << LOG];
    private int pixel;
    private int first = -1;
    /** Counts passes. */
    private int pass;

    /** What is added to a dimension for each sequence. */
    private final int scramble;
    /** Of each sample of the pass its number in its sequence, in reversed order. */
    private final int[] within = new int[PASS];
    private final int[] reversed = new int[PASS];
    private final int[] places = new int[PASS];
    private final int[] keys = new int[PASS];
    private final int[] indices = new int[PASS];

    /** @param scramble what is added to a dimension for each sequence */
    PassPoints(int scramble) {
        this.scramble = scramble;
        for (int i = 0; i < PASS; i++) {
            within[i] = Integer.reverse(Sampler.inSequence(i));
        }
    }

    /** Turns to a pixel's pass, that which a sample is of. */
    void turnTo(int toPixel, int sample) {
        if (pixel != toPixel || first != sample / PASS) {
            pixel = toPixel;
            first = sample / PASS;
            if (++pass < 0) {
                Arrays.fill(passes, 0);
                pass = 1;
            }
            int base = Integer.reverse(Sampler.inSequence(first * PASS));
            for (int i = 0; i < PASS; i++) {
                reversed[i] = within[i] | base;
            }
        }
    }

    /**
     * Where a sample's point of a dimension is, or {@link #ALONE}.
     *
     * @param dimension without what tells sequences apart
     * @param size how many digits number the points
     */
    int find(int dimension, int sample, int size) {
        int entry = (dimension * SPREAD) >>> (Integer.SIZE - LOG);
        if (dimensions[entry] != dimension || (passes[entry] != pass && passes[entry] != -pass)) {
            dimensions[entry] = dimension;
            passes[entry] = -pass;
            return ALONE;
        }
        if (passes[entry] != pass) {
            passes[entry] = pass;
            fill(dimension, size, entry * PASS);
        }
        return entry * PASS + sample % PASS;
    }

    int u(int at) {
        return us[at];
    }

    int v(int at) {
        return vs[at];
    }

    /** The same as {@link Sampler} makes one by one, from a place on. */
    private void fill(int dimension, int size, int at) {
        sequences(dimension, size);
        index(size, reversed, places, indices);
        second(indices, keys, places);
        System.arraycopy(places, 0, vs, at, PASS);
        first(indices, keys, places);
        System.arraycopy(places, 0, us, at, PASS);
    }

    /** What is the same for all samples of a sequence, which follow each other: made once for each, and then put beside each sample. */
    private void sequences(int dimension, int size) {
        int reversedPixel = Integer.reverse(pixel);
        for (int i = 0; i < PASS; i += Sampler.RUN) {
            int own = dimension + scramble * Sampler.scramble(i);
            int place = Integer.reverse(Sampler.permuted(reversedPixel, Sampler.mixed(own ^ Sampler.ORDER)));
            int key = Sampler.mixed(own + (place >>> (Integer.SIZE - size)));
            int order = Sampler.mixed(place ^ Sampler.mixed(own));
            for (int k = i; k < i + Sampler.RUN; k++) {
                places[k] = place << size;
                keys[k] = key;
                indices[k] = order;
            }
        }
    }

    /** Makes indices of orders. */
    private static void index(int size, int[] reversed, int[] places, int[] orders) {
        int within = (1 << size) - 1;
        for (int i = 0; i < PASS; i++) {
            orders[i] = places[i] | (reverse(Sampler.permuted(reversed[i], orders[i])) & within);
        }
    }

    private static void first(int[] indices, int[] keys, int[] us) {
        for (int i = 0; i < PASS; i++) {
            us[i] = reverse(Sampler.permuted(indices[i], keys[i]));
        }
    }

    private static void second(int[] indices, int[] keys, int[] vs) {
        for (int i = 0; i < PASS; i++) {
            vs[i] = reverse(Sampler.permuted(Sampler.second(indices[i]), keys[i] ^ Sampler.SECOND));
        }
    }

    /** As {@link Integer#reverse}, of which not every JVM makes vectors. */
    private static int reverse(int x) {
        int y = x;
        y = (y & 0x5555_5555) << 1 | (y >>> 1 & 0x5555_5555);
        y = (y & 0x3333_3333) << 2 | (y >>> 2 & 0x3333_3333);
        y = (y & 0x0F0F_0F0F) << 4 | (y >>> 4 & 0x0F0F_0F0F);
        y = (y & 0x00FF_00FF) << 8 | (y >>> 8 & 0x00FF_00FF);
        return y << 16 | y >>> 16;
    }
}
