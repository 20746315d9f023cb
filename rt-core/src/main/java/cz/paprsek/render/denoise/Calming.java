package cz.paprsek.render.denoise;

import java.util.Arrays;

/** Takes noise out of what guides, and out of variances. Scratch of one worker. */
final class Calming implements Stage.Step {
    private static final int REACH = 5;
    private static final int AROUND = 1;
    /** k². */
    private static final float TOLERANCE = 1;
    /** Guides of so little variance have no noise that would be seen. */
    private static final float CLEAR = 1e-6f;
    /** Where colours, normal and distance begin, and end. */
    private static final int[] KINDS = {0, 3, 6, 7};

    private final Noisy from;
    private final Noisy to;
    private final Window window = new Window(REACH + AROUND + 1);
    private final Likeness likeness = new Likeness(window, AROUND, TOLERANCE);
    private final float[] plane = window.newImage();
    private final float[] smoothed = window.newImage();
    private final float[][] values;
    private final float[][] variances;
    private final float[][] sums;
    private final float[] weights = new float[window.span];
    private final float[] all = new float[window.span];

    Calming(Noisy from, Noisy to) {
        this.from = from;
        this.to = to;
        values = new float[from.guides.length][];
        variances = new float[from.guides.length][];
        sums = new float[from.guides.length][window.span];
        for (int i = 0; i < values.length; i++) {
            values[i] = window.newImage();
            variances[i] = window.newImage();
        }
    }

    @Override
    public void at(int left, int top) {
        window.moveTo(left, top, from.width, from.height);
        for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
            window.copy(from.spread[channel], plane);
            smooth(plane, smoothed);
            put(left, top, smoothed, to.spread[channel]);
        }
        for (int i = 0; i < values.length; i++) {
            window.copy(from.guides[i], values[i]);
            window.copy(from.doubts[i], plane);
            smooth(plane, variances[i]);
        }
        for (int kind = 0; kind + 1 < KINDS.length; kind++) {
            calm(left, top, KINDS[kind], KINDS[kind + 1]);
        }
    }

    /** Half of its own value, and half of that of those around. */
    private void smooth(float[] image, float[] out) {
        int stride = window.stride;
        for (int i = stride + 1; i < image.length - stride - 1; i++) {
            float sum = image[i - stride - 1] + image[i - stride] + image[i - stride + 1] + image[i - 1] + image[i + 1]
                    + image[i + stride - 1] + image[i + stride] + image[i + stride + 1];
            out[i] = (image[i] + sum / 8) / 2;
        }
    }

    private void calm(int left, int top, int begin, int end) {
        if (areClear(begin, end)) {
            for (int i = begin; i < end; i++) {
                put(left, top, values[i], to.guides[i]);
            }
        } else {
            gather(begin, end);
            putMeans(left, top, begin, end);
        }
    }

    private boolean areClear(int begin, int end) {
        float most = 0;
        for (int i = begin; i < end; i++) {
            for (float one : variances[i]) {
                most = Math.max(most, one);
            }
        }
        return most < CLEAR;
    }

    private void gather(int begin, int end) {
        float[][] own = Arrays.copyOfRange(values, begin, end);
        float[][] doubts = Arrays.copyOfRange(variances, begin, end);
        Arrays.fill(all, 0);
        for (int i = begin; i < end; i++) {
            Arrays.fill(sums[i], 0);
        }
        for (int dy = -REACH; dy <= REACH; dy++) {
            for (int dx = -REACH; dx <= REACH; dx++) {
                likeness.compare(dx, dy, own, doubts, weights);
                int at = window.at(dx, dy);
                for (int k = 0; k < all.length; k++) {
                    all[k] += weights[k];
                }
                for (int i = begin; i < end; i++) {
                    add(weights, values[i], at, sums[i]);
                }
            }
        }
    }

    private void putMeans(int left, int top, int begin, int end) {
        for (int i = begin; i < end; i++) {
            for (int row = 0; row < Math.min(Window.HEIGHT, from.height - top); row++) {
                for (int column = 0; column < Math.min(Window.WIDTH, from.width - left); column++) {
                    to.guides[i][(top + row) * from.width + left + column] = sums[i][row * window.stride + column] / all[row * window.stride + column];
                }
            }
        }
    }

    private static void add(float[] weights, float[] value, int at, float[] into) {
        for (int k = 0; k < into.length; k++) {
            into[k] += weights[k] * value[at + k];
        }
    }

    private void put(int left, int top, float[] image, float[] into) {
        for (int row = 0; row < Math.min(Window.HEIGHT, from.height - top); row++) {
            for (int column = 0; column < Math.min(Window.WIDTH, from.width - left); column++) {
                into[(top + row) * from.width + left + column] = image[window.at(column, row)];
            }
        }
    }
}
