package cz.paprsek.render.sample;

import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.scene.RenderSettings;

/**
 * Tells when a pixel has enough samples: once its value as it is shown, from 0 to 1, is known as well as is wished. Judged by the samples of the
 * pixel alone; scratch of one worker.
 *
 * <p>The samples are taken as groups, each of neighbours in a sequence that spreads its points evenly, or each of a sequence of its own. From the standard
 * deviation s of the means of n groups follows that of the mean of all, s/√n; of neighbours it is too large rather than too small, because the groups fill each
 * other's gaps. Samples that are all alike are taken for all there is to see.
 * The interval is that of Student's t with n − 1 degrees of freedom, at a confidence that is shared by all times it is looked at.
 */
final class Target {
    /** Fewer samples have no spread. */
    static final int FEWEST = 4;
    /** The interval of a value of which nothing is known. */
    static final double UNKNOWN = -1;
    /** Which share of the light a single sample may bring. */
    private static final double MOST_OF_ONE = 0.3;
    /** Of normal deviates it is 3, of eight of them about 2.3; of eight numbers of which one is not like the others, 6.1. */
    private static final double MOST_KURTOSIS = 5;

    private final double error;
    private final double t;
    private final double unmet;
    private final double gain;
    private final Tone tone;
    private final int groups;
    private final double[] reds;
    private final double[] greens;
    private final double[] blues;

    /**
     * How well a pixel is to be known.
     *
     * @param groups how many groups of samples there are: an even number
     * @param looks how often a pixel is judged at most
     */
    Target(RenderSettings settings, int groups, int looks) {
        this.error = settings.error();
        this.t = quantile((1 - settings.confidence()) / Math.max(1, looks), groups - 1);
        this.unmet = -StrictMath.log(1 - settings.confidence());
        this.gain = StrictMath.pow(2, settings.exposure());
        this.tone = settings.tone();
        this.groups = groups;
        reds = new double[groups];
        greens = new double[groups];
        blues = new double[groups];
    }

    /** Says what the mean of a group is: the sums' red, green and blue. */
    void group(int number, PixelSums mean) {
        reds[number] = mean.red;
        greens[number] = mean.green;
        blues[number] = mean.blue;
    }

    /** How many samples of a kind there should be at most, with the confidence that is asked for, if none has been met: the rule of three. */
    double unmet() {
        return unmet;
    }

    /** Whether a value that may be so far from the true one is known well enough. */
    boolean isMet(double halfWidth) {
        return halfWidth <= error;
    }

    /**
     * How far the value that is shown, of the groups told, may be from the true one, in the channel where that is farthest.
     *
     * @param red what the interval of each channel reaches to each side at least
     */
    double halfWidth(double red, double green, double blue) {
        return Math.max(halfWidth(reds, red), Math.max(halfWidth(greens, green), halfWidth(blues, blue)));
    }

    /**
     * Whether {@link #halfWidth} of the groups told can be trusted: not if a single sample brings much of the light, or a single group stands out among the others. Then
     * there may be rare samples as bright or brighter, and how many of them there should be, so few do not tell.
     */
    boolean isTrusted(double red, double green, double blue) {
        return isTrusted(reds, red) && isTrusted(greens, green) && isTrusted(blues, blue);
    }

    private boolean isTrusted(double[] means, double step) {
        double mean = mean(means);
        double squares = 0;
        double fourths = 0;
        for (double one : means) {
            double square = (one - mean) * (one - mean);
            squares += square;
            fourths += square * square;
        }
        return step <= MOST_OF_ONE * Math.abs(mean) && groups * fourths <= MOST_KURTOSIS * squares * squares;
    }

    private double mean(double[] means) {
        double mean = 0;
        for (double one : means) {
            mean += one;
        }
        return mean / groups;
    }

    private double halfWidth(double[] means, double step) {
        double mean = mean(means);
        double squares = 0;
        for (double one : means) {
            squares += (one - mean) * (one - mean);
        }
        double half = Math.max(step, t * Math.sqrt(squares / (groups - 1) / groups));
        if (half == 0) {
            return 0;
        }
        return (shown(tone.of(gain * (mean + half))) - shown(tone.of(gain * (mean - half)))) / 2;
    }

    /** Of linear light, the sRGB value, from black as 0 to white as 1. */
    private static double shown(double light) {
        return light <= 0 ? 0 : light >= 1 ? 1 : light <= 0.0031308 ? 12.92 * light : 1.055 * StrictMath.pow(light, 1 / 2.4) - 0.055;
    }

    /**
     * What a t exceeds, to either side, with the given probability.
     *
     * @param freedom degrees of it: an odd number from 3 on
     * @source Abramowitz and Stegun, Handbook of Mathematical Functions, 26.7.3
     */
    static double quantile(double probability, int freedom) {
        double low = 0;
        double high = 1e9;
        for (int i = 0; i < 200; i++) {
            double middle = (low + high) / 2;
            double x = middle / Math.sqrt(freedom);
            double term = x / (1 + x * x);
            double sum = term;
            for (int k = 3; k < freedom - 1; k += 2) {
                term *= (k - 1) / (k * (1 + x * x));
                sum += term;
            }
            double inside = 2 / Math.PI * (sum + StrictMath.atan(x));
            if (1 - inside > probability) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return high;
    }
}
