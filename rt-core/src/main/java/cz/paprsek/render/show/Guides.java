package cz.paprsek.render.show;

/**
 * What guides a denoiser: how the first surface that a pixel's paths meet looks which strews light, each half of the sequences that the paths are taken from by itself, so that it
 * is known how sure that is. Scratch of one worker.
 */
public final class Guides {
    /** How much light the surface strews, by colours; its normal, world space; and how far away it is, from 0 for the eye to 1 for infinity. */
    public static final int COUNT = 7;
    /** How many numbers are kept of a pixel: sums of the one half, then of the other. */
    public static final int SIZE = 2 * COUNT;

    final KeptSums sums = new KeptSums(SIZE);

    Guides() {}

    /** @param half 0 or 1 */
    void add(int half, double[] guide) {
        for (int i = 0; i < COUNT; i++) {
            sums.add(COUNT * half + i, guide[i]);
        }
    }
}
