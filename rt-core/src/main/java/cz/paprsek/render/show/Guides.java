package cz.paprsek.render.show;

import java.util.Arrays;

/**
 * What guides a denoiser: how the first surface that a pixel's paths meet looks which strews light, each half of the sequences that the paths are taken from by itself, so that it
 * is known how sure that is. Scratch of one worker.
 */
public final class Guides {
    /** How much light the surface strews, by colours; its normal, world space; and how far away it is, from 0 for the eye to 1 for infinity. */
    public static final int COUNT = 7;
    /** How many numbers are kept of a pixel: sums of the one half, then of the other. */
    public static final int SIZE = 2 * COUNT;

    private final double[] sums = new double[SIZE];

    Guides() {}

    void clear() {
        Arrays.fill(sums, 0);
    }

    /** @param half 0 or 1 */
    void add(int half, double[] guide) {
        for (int i = 0; i < COUNT; i++) {
            sums[COUNT * half + i] += guide[i];
        }
    }

    /** Rounds the sums to what is kept of them. */
    void round() {
        for (int i = 0; i < SIZE; i++) {
            sums[i] = (float) sums[i];
        }
    }

    /** Keeps the sums, from a place on; where what follows them begins. */
    int save(float[] numbers, int from) {
        for (int i = 0; i < SIZE; i++) {
            numbers[from + i] = (float) sums[i];
        }
        return from + SIZE;
    }

    /** Goes on with sums that were kept. */
    int load(float[] numbers, int from) {
        for (int i = 0; i < SIZE; i++) {
            sums[i] = numbers[from + i];
        }
        return from + SIZE;
    }
}
