package cz.paprsek.render.denoise;

import cz.paprsek.image.Image;
import java.util.Arrays;

/** Chooses for each pixel the way of which the error is least around it. Scratch of one worker. */
final class Choosing implements Stage.Step {
    /** Errors are known from one pixel as little as its light is: those of so many around it are added. */
    private static final int REACH = 6;
    /** Between two ways there is no edge: it is so many pixels wide to each side. */
    private static final int BLUR = 1;
    private static final int SIDE = 2 * BLUR + 1;
    private static final int WIDE = Window.WIDTH + 2 * BLUR;

    private final Found found;
    private final Image image;
    private final int width;
    private final int height;
    private final Window window = new Window(REACH + BLUR);
    private final float[][] errors;
    private final int[] best = new int[WIDE * (Window.HEIGHT + 2 * BLUR)];
    private final double[] value = new double[Noisy.CHANNELS];

    Choosing(Noisy noisy, Found found, Image image) {
        this.found = found;
        this.image = image;
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
                set(left + column, top + row);
            }
        }
    }

    /** The mean of what is best for the pixels around one. */
    private void mix(int corner, int pixel) {
        Arrays.fill(value, 0);
        for (int dy = 0; dy < SIDE; dy++) {
            for (int dx = 0; dx < SIDE; dx++) {
                float[][] light = found.light[best[corner + dy * WIDE + dx]];
                for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
                    value[channel] += light[channel][pixel];
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

    private void set(int x, int y) {
        double share = 1.0 / (SIDE * SIDE);
        double red = Math.max(0, value[0] * share);
        double green = Math.max(0, value[1] * share);
        double blue = Math.max(0, value[2] * share);
        if (!(red + green + blue <= Float.MAX_VALUE)) {
            // Lights so bright that their squares are not numbers: the pixel stays as it was traced.
            return;
        }
        if (image.isTransparent()) {
            image.set(x, y, red, green, blue, image.alpha(x, y));
        } else {
            image.set(x, y, red, green, blue);
        }
    }
}
