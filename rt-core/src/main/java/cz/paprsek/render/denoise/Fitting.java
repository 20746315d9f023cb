package cz.paprsek.render.denoise;

import java.util.Arrays;

/** Lays planes through the neighbours of each pixel, in several ways. Scratch of one worker. */
final class Fitting implements Stage.Step {
    /** How far away neighbours are at most, by columns and by rows. */
    private static final int REACH = 7;
    /** How much of what guides must vary to count by half: in squares of shares of light, and of sines of angles. */
    private static final double RELUCTANCE = 1e-4;
    /** The same of the place, of which {@value #REACH} pixels are 1: only where nothing else explains it. */
    private static final double RELUCTANCE_OF_PLACE = 1e-2;
    /** Errors are told by the variance of noise; and where there is next to none, by this share of the square of the light, and by no less than that of black. */
    private static final double EXACT = 1e-4;
    private static final double DARKEST = 1e-8;

    private final Noisy noisy;
    private final Noisy guess;
    private final Found found;
    private final int ways;
    private final Window window;
    private final float[][][] light = new float[Noisy.HALVES][Noisy.CHANNELS][];
    private final float[][] spread = new float[Noisy.CHANNELS][];
    private final float[][][] guessed = new float[Noisy.HALVES][Noisy.CHANNELS][];
    private final float[][] doubt = new float[Noisy.CHANNELS][];
    private final float[][] variables;
    private final double[] reluctance;
    private final Likeness[] likeness;
    private final float[][] weights;
    private final Fit fit;
    private final double[][][][] value;

    /**
     * In so many ways as there are tolerances.
     *
     * @param guess by whose light and spread neighbours count; at first the noisy picture itself
     * @param around how far around two pixels is compared
     * @param tolerances k² of each way: how many variances neighbours may be from the pixel
     */
    Fitting(Noisy noisy, Noisy guess, int around, float[] tolerances, Found found) {
        this.noisy = noisy;
        this.guess = guess;
        this.found = found;
        ways = tolerances.length;
        window = new Window(REACH + around);
        weights = new float[Fit.TOGETHER][window.span];
        value = new double[ways][Noisy.HALVES][Noisy.CHANNELS][window.span];
        int guides = noisy.guides.length;
        variables = new float[guides + 3][];
        reluctance = new double[guides + 3];
        Arrays.fill(reluctance, RELUCTANCE);
        reluctance[guides + 1] = RELUCTANCE_OF_PLACE;
        reluctance[guides + 2] = RELUCTANCE_OF_PLACE;
        for (int i = 0; i < variables.length; i++) {
            variables[i] = window.newImage();
        }
        Arrays.fill(variables[0], 1);
        for (int row = -REACH; row < Window.HEIGHT + REACH; row++) {
            for (int column = -REACH; column < Window.WIDTH + REACH; column++) {
                variables[guides + 1][window.at(column, row)] = (column - Window.WIDTH / 2f) / REACH;
                variables[guides + 2][window.at(column, row)] = (row - Window.HEIGHT / 2f) / REACH;
            }
        }
        for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
            for (int half = 0; half < Noisy.HALVES; half++) {
                light[half][channel] = window.newImage();
                guessed[half][channel] = window.newImage();
            }
            spread[channel] = window.newImage();
            doubt[channel] = window.newImage();
        }
        likeness = new Likeness[ways];
        for (int i = 0; i < ways; i++) {
            likeness[i] = new Likeness(window, around, tolerances[i]);
        }
        fit = new Fit(window, guides + 2);
    }

    @Override
    public void at(int left, int top) {
        window.moveTo(left, top, noisy.width, noisy.height);
        for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
            for (int half = 0; half < Noisy.HALVES; half++) {
                window.copy(noisy.light[half][channel], light[half][channel]);
                window.copy(guess.light[half][channel], guessed[half][channel]);
            }
            window.copy(noisy.spread[channel], spread[channel]);
            window.copy(guess.spread[channel], doubt[channel]);
        }
        for (int i = 0; i < noisy.guides.length; i++) {
            window.copy(noisy.guides[i], variables[i + 1]);
            center(variables[i + 1]);
        }
        int rows = Math.min(Window.HEIGHT, noisy.height - top);
        int columns = Math.min(Window.WIDTH, noisy.width - left);
        for (int half = 0; half < Noisy.HALVES; half++) {
            for (int i = 0; i < likeness.length; i++) {
                gather(half, likeness[i]);
                for (int row = 0; row < rows; row++) {
                    for (int column = 0; column < columns; column++) {
                        int pixel = row * window.stride + column;
                        fit.solve(pixel, window.at(column, row), variables, reluctance);
                        take(value[i][half], pixel);
                    }
                }
            }
        }
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                judge(row * window.stride + column, window.at(column, row), (top + row) * noisy.width + left + column);
            }
        }
    }

    private static void center(float[] image) {
        double sum = 0;
        for (float one : image) {
            sum += one;
        }
        float mean = (float) (sum / image.length);
        for (int i = 0; i < image.length; i++) {
            image[i] -= mean;
        }
    }

    private void gather(int half, Likeness likeness) {
        fit.clear();
        for (int dy = -REACH; dy <= REACH; dy++) {
            for (int dx = -REACH; dx <= REACH; dx += Fit.TOGETHER) {
                for (int i = 0; i < Fit.TOGETHER; i++) {
                    likeness.compare(dx + i, dy, guessed[1 - half], doubt, weights[i]);
                }
                fit.add(weights, window.at(dx, dy), variables, light[half]);
            }
        }
    }

    private void take(double[][] into, int pixel) {
        for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
            into[channel][pixel] = fit.value[channel];
        }
    }

    /** How far each way is from the half that it knows nothing of: by the square, less what that half itself is wrong. */
    private void judge(int pixel, int at, int out) {
        double scale = DARKEST;
        for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
            double mean = (value[0][0][channel][pixel] + value[0][1][channel][pixel]) / 2;
            scale += spread[channel][at] + EXACT * mean * mean;
        }
        for (int way = 0; way < ways; way++) {
            double error = 0;
            for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
                double first = value[way][0][channel][pixel];
                double second = value[way][1][channel][pixel];
                double a = first - light[1][channel][at];
                double b = second - light[0][channel][at];
                error += (a * a + b * b) / 2 - spread[channel][at];
                found.light[way][0][channel][out] = (float) first;
                found.light[way][1][channel][out] = (float) second;
            }
            found.error[way][out] = (float) (error / scale);
        }
    }
}
