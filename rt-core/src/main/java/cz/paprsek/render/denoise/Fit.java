package cz.paprsek.render.denoise;

import java.util.Arrays;

/**
 * For each pixel of a tile, the plane of first order that is nearest to its neighbours, as much as each weighs: light as a linear function of what guides. Scratch of one worker.
 *
 * @source Bitterli et al., Nonlinearly Weighted First-order Regression for Denoising Monte Carlo Renderings, Computer Graphics Forum 35(4), 2016
 */
final class Fit {
    /** How many neighbours are added at once: sums are fetched from memory less often. */
    static final int TOGETHER = 5;
    private static final int CHANNELS = Noisy.CHANNELS;

    private final int size;
    /** Sums of weights times products of two of: 1 and the variables. */
    private final float[][] products;
    /** Sums of weights times a channel times one of them. */
    private final float[][] rights;
    private final float[][] weighted;
    private final double[] mean;
    private final double[][] matrix;
    private final double[][] right;
    /** What was found: each channel with every strength. */
    final double[] value = new double[CHANNELS];

    /** @param variables how many there are beside 1 */
    Fit(Window window, int variables) {
        size = variables + 1;
        weighted = new float[TOGETHER][window.span];
        products = new float[size * (size + 1) / 2][window.span];
        rights = new float[CHANNELS * size][window.span];
        mean = new double[size];
        matrix = new double[size][size];
        right = new double[CHANNELS][size];
    }

    void clear() {
        for (float[] sums : products) {
            Arrays.fill(sums, 0);
        }
        for (float[] sums : rights) {
            Arrays.fill(sums, 0);
        }
    }

    /**
     * Adds to each pixel {@value #TOGETHER} neighbours, side by side.
     *
     * @param weights of the window's span, by neighbours
     * @param at where in the window the first pixel's first neighbour is
     * @param variables images of the window, the first of which is 1 everywhere
     * @param light likewise
     */
    void add(float[][] weights, int at, float[][] variables, float[][] light) {
        int k = 0;
        for (int a = 0; a < size; a++) {
            for (int i = 0; i < TOGETHER; i++) {
                multiply(weights[i], variables[a], at + i, weighted[i]);
            }
            for (int b = 0; b <= a; b++) {
                add(variables[b], at, products[k++]);
            }
            for (int channel = 0; channel < CHANNELS; channel++) {
                add(light[channel], at, rights[channel * size + a]);
            }
        }
    }

    private static void multiply(float[] weights, float[] variable, int at, float[] out) {
        for (int i = 0; i < out.length; i++) {
            out[i] = weights[i] * variable[at + i];
        }
    }

    private void add(float[] variable, int at, float[] sums) {
        float[] w = weighted[0];
        float[] w1 = weighted[1];
        float[] w2 = weighted[2];
        float[] w3 = weighted[3];
        float[] w4 = weighted[4];
        for (int i = 0; i < sums.length; i++) {
            sums[i] += w[i] * variable[at + i] + w1[i] * variable[at + i + 1] + w2[i] * variable[at + i + 2] + w3[i] * variable[at + i + 3] + w4[i] * variable[at + i + 4];
        }
    }

    /**
     * The plane, at the pixel itself.
     *
     * @param at where it is in the window
     * @param reluctance of each variable, how much its variance must be for it to count by half
     */
    void solve(int pixel, int at, float[][] variables, double[] reluctance) {
        double share = 1 / products[0][pixel];
        int k = 0;
        for (int a = 0; a < size; a++) {
            mean[a] = products[k][pixel] * share;
            for (int b = 0; b <= a; b++) {
                matrix[a][b] = products[k++][pixel] * share - mean[a] * mean[b];
            }
            for (int channel = 0; channel < CHANNELS; channel++) {
                float[] sums = rights[channel * size + a];
                right[channel][a] = sums[pixel] * share - mean[a] * rights[channel * size][pixel] * share;
            }
        }
        for (int a = 1; a < size; a++) {
            matrix[a][a] += reluctance[a];
        }
        decompose();
        for (int channel = 0; channel < CHANNELS; channel++) {
            double[] b = right[channel];
            substitute(b);
            double sum = rights[channel * size][pixel] * share;
            for (int a = 1; a < size; a++) {
                sum += b[a] * (variables[a][at] - mean[a]);
            }
            value[channel] = sum;
        }
        hold(pixel, share);
    }

    /** No light is less than none: the farther below a plane leads, the less steep it is taken to be. Beside what is very bright a single pixel would else be black. */
    private void hold(int pixel, double share) {
        double steep = 1;
        for (int channel = 0; channel < CHANNELS; channel++) {
            double middle = rights[channel * size][pixel] * share;
            if (value[channel] < 0 && middle > 0) {
                double above = middle / (middle - value[channel]);
                steep = Math.min(steep, above * above);
            }
        }
        for (int channel = 0; channel < CHANNELS && steep < 1; channel++) {
            double middle = rights[channel * size][pixel] * share;
            value[channel] = middle + steep * (value[channel] - middle);
        }
    }

    /** Cholesky's decomposition, in place. */
    private void decompose() {
        for (int a = 1; a < size; a++) {
            double[] row = matrix[a];
            for (int b = 1; b <= a; b++) {
                double[] other = matrix[b];
                double sum = row[b];
                for (int c = 1; c < b; c++) {
                    sum -= row[c] * other[c];
                }
                row[b] = b == a ? Math.sqrt(Math.max(sum, 1e-12)) : sum / other[b];
            }
        }
    }

    private void substitute(double[] b) {
        for (int a = 1; a < size; a++) {
            double sum = b[a];
            for (int c = 1; c < a; c++) {
                sum -= matrix[a][c] * b[c];
            }
            b[a] = sum / matrix[a][a];
        }
        for (int a = size - 1; a >= 1; a--) {
            double sum = b[a];
            for (int c = a + 1; c < size; c++) {
                sum -= matrix[c][a] * b[c];
            }
            b[a] = sum / matrix[a][a];
        }
    }
}
