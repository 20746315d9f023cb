package cz.paprsek.render.denoise;

import java.util.Arrays;

/**
 * How much pixels of a tile are like others, by the pixels around both: as much as is likely if but noise sets them apart. Scratch of one worker.
 *
 * @source Rousselle, Knaus and Zwicker, Adaptive Rendering with Non-Local Means Filtering, ACM Transactions on Graphics 31(6), 2012
 */
final class Likeness {
    /** Smaller variances are rounding. */
    private static final float LEAST = 1e-10f;
    /** Who is unsure might be anything, which makes it like nobody: its variance counts up to so many times that of who is sure, which is at least a share of its square. */
    private static final float UNSURE = 1e6f;
    private static final float SURE = 1e-4f;
    /** The square of a distance from which on pixels are not alike at all. */
    private static final float FARTHEST = 4;

    private final Window window;
    private final int reach;
    /** k², by how many variances pixels may differ. */
    private final float tolerance;
    private final float[] delta;
    private final float[] across;

    /** @param reach how many pixels around each are compared, to each side */
    Likeness(Window window, int reach, float tolerance) {
        this.window = window;
        this.reach = reach;
        this.tolerance = tolerance;
        delta = new float[window.span + 2 * reach * (window.stride + 1)];
        across = new float[window.span + 2 * reach * window.stride];
    }

    /**
     * Compares each pixel of the window's {@linkplain Window#span span} with the one that is so far from it.
     *
     * @param values by channels
     * @param variances of them
     * @param weights gets one for each pixel
     */
    void compare(int dx, int dy, float[][] values, float[][] variances, float[] weights) {
        int shift = dy * window.stride + dx;
        Arrays.fill(delta, 0);
        for (int channel = 0; channel < values.length; channel++) {
            distances(values[channel], variances[channel], window.at(-reach, -reach), shift);
        }
        Arrays.fill(across, 0);
        Arrays.fill(weights, 0);
        for (int i = 0; i <= 2 * reach; i++) {
            add(delta, i, across);
        }
        for (int i = 0; i <= 2 * reach; i++) {
            add(across, i * window.stride, weights);
        }
        float side = 2 * reach + 1;
        weigh(weights, window.at(dx, dy), 1 / (FARTHEST * side * side * values.length));
    }

    private void distances(float[] value, float[] variance, int at, int shift) {
        float[] out = delta;
        float k = tolerance;
        for (int i = 0; i < out.length; i++) {
            float here = value[at + i];
            float d = here - value[at + i + shift];
            float own = variance[at + i];
            float other = Math.min(variance[at + i + shift], UNSURE * (own + SURE * here * here));
            out[i] += (d * d - (own + Math.min(own, other))) / (LEAST + k * (own + other));
        }
    }

    private static void add(float[] from, int at, float[] into) {
        for (int i = 0; i < into.length; i++) {
            into[i] += from[at + i];
        }
    }

    /** (1 − d²/4)⁴ is about exp(−d²). */
    private void weigh(float[] out, int at, float share) {
        float[] inside = window.inside;
        for (int i = 0; i < out.length; i++) {
            float left = Math.max(0, 1 - Math.max(0, out[i] * share));
            float square = left * left;
            out[i] = square * square * inside[at + i];
        }
    }
}
