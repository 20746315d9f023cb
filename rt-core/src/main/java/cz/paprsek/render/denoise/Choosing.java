package cz.paprsek.render.denoise;

import java.util.Arrays;

/** Chooses for each pixel the way of which the error is least around it. Scratch of one worker. */
final class Choosing implements Stage.Step {
    /** Errors are known from one pixel as little as its light is: those of so many around it are added. */
    private static final int REACH = 6;
    /** Between two ways there is no edge: it is so many pixels wide to each side. */
    private static final int BLUR = 1;
    private static final int SIDE = 2 * BLUR + 1;
    private static final double SHARE = 1.0 / (SIDE * SIDE);
    private static final int WIDE = Window.WIDTH + 2 * BLUR;

    private final Found found;
    private final Sink sink;
    private final int width;
    private final int height;
    private final Window window = new Window(REACH + BLUR);
    private final float[][] errors;
    private final int[] best = new int[WIDE * (Window.HEIGHT + 2 * BLUR)];
    private final double[][] value = new double[Noisy.HALVES][Noisy.CHANNELS];

    /** Gets what was chosen. */
    interface Sink {
        /** @param halves what each half of the paths says of a pixel, by channels; valid during the call only */
        void set(int x, int y, double[][] halves);
    }

    Choosing(Noisy noisy, Found found, Sink sink) {
        this.found = found;
        this.sink = sink;
        width = noisy.width;
        height = noisy.height;
        errors = new float[found.error.length][];
        for (int i = 0; i < errors.length; i++) {
            errors[i] = window.newImage();
        }
    }

    @Override
    public void at(int left, int top) {
        window.moveTo(left, top, width, height);
        for (int way = 0; way < errors.length; way++) {
            window.copy(found.error[way], errors[way]);
        }
        for (int row = -BLUR; row < Window.HEIGHT + BLUR; row++) {
            for (int column = -BLUR; column < Window.WIDTH + BLUR; column++) {
                best[(row + BLUR) * WIDE + column + BLUR] = best(window.at(column, row));
            }
        }
        for (int row = 0; row < Math.min(Window.HEIGHT, height - top); row++) {
            for (int column = 0; column < Math.min(Window.WIDTH, width - left); column++) {
                mix(row * WIDE + column, (top + row) * width + left + column);
                sink.set(left + column, top + row, value);
            }
        }
    }

    /** The mean of what is best for the pixels around one. */
    private void mix(int corner, int pixel) {
        for (int half = 0; half < Noisy.HALVES; half++) {
            Arrays.fill(value[half], 0);
            for (int dy = 0; dy < SIDE; dy++) {
                for (int dx = 0; dx < SIDE; dx++) {
                    float[][] light = found.light[best[corner + dy * WIDE + dx]][half];
                    for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
                        value[half][channel] += light[channel][pixel] * SHARE;
                    }
                }
            }
        }
    }

    private int best(int at) {
        int best = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int way = 0; way < errors.length; way++) {
            double sum = 0;
            for (int dy = -REACH; dy <= REACH; dy++) {
                for (int dx = -REACH; dx <= REACH; dx++) {
                    sum += errors[way][at + dy * window.stride + dx];
                }
            }
            if (sum < least) {
                least = sum;
                best = way;
            }
        }
        return best;
    }
}
