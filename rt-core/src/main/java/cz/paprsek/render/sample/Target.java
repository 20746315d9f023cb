package cz.paprsek.render.sample;

import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.scene.RenderSettings;

/**
 * Tells when a pixel has enough samples: once its value as it is shown, from 0 to 1, is known as well as is wished. Judged by the samples of the
 * pixel alone; scratch of one worker.
 *
 * <p>The samples are taken as four groups, each of neighbours in a sequence that spreads its points evenly. From the standard deviation s of the
 * groups' means follows that of the mean of all, s/2; it is too large rather than too small, because the groups fill each other's gaps.
 * Samples that are all alike are taken for all there is to see.
 * The interval is that of Student's t with three degrees of freedom, at a confidence that is shared by all times it is looked at.
 */
final class Target {
    /** Fewer samples have no spread. */
    static final int FEWEST = 4;
    private static final int GROUPS = 4;

    private final double error;
    private final double t;
    private final double gain;
    private final Tone tone;
    private final double[] reds = new double[GROUPS];
    private final double[] greens = new double[GROUPS];
    private final double[] blues = new double[GROUPS];

    /** @param looks how often a pixel is judged at most */
    Target(RenderSettings settings, int looks) {
        this.error = settings.error();
        this.t = quantile((1 - settings.confidence()) / Math.max(1, looks));
        this.gain = StrictMath.pow(2, settings.exposure());
        this.tone = settings.tone();
    }

    boolean isMet(PixelSums sums) {
        for (int i = 0; i < GROUPS; i++) {
            sums.mean(i * sums.count() / GROUPS, (i + 1) * sums.count() / GROUPS);
            reds[i] = sums.red;
            greens[i] = sums.green;
            blues[i] = sums.blue;
        }
        // Four groups may happen to agree: one sample on the wrong side of an edge is always thought possible.
        double share = 1.0 / sums.count();
        return isNear(reds, share * sums.range(0)) && isNear(greens, share * sums.range(1)) && isNear(blues, share * sums.range(2));
    }

    /** @param step what the interval reaches to each side at least */
    private boolean isNear(double[] means, double step) {
        double mean = (means[0] + means[1] + means[2] + means[3]) / GROUPS;
        double squares = 0;
        for (double one : means) {
            squares += (one - mean) * (one - mean);
        }
        double half = Math.max(step, t * Math.sqrt(squares / (GROUPS - 1) / GROUPS));
        if (half == 0) {
            return true;
        }
        return shown(tone.of(gain * (mean + half))) - shown(tone.of(gain * (mean - half))) <= 2 * error;
    }

    /** Of linear light, the sRGB value, from black as 0 to white as 1. */
    private static double shown(double light) {
        return light <= 0 ? 0 : light >= 1 ? 1 : light <= 0.0031308 ? 12.92 * light : 1.055 * StrictMath.pow(light, 1 / 2.4) - 0.055;
    }

    /** What a t of three degrees of freedom exceeds, to either side, with the given probability. */
    private static double quantile(double probability) {
        double low = 0;
        double high = 1e9;
        for (int i = 0; i < 200; i++) {
            double middle = (low + high) / 2;
            double x = middle / Math.sqrt(3);
            double inside = 2 / Math.PI * (x / (1 + x * x) + StrictMath.atan(x));
            if (1 - inside > probability) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return high;
    }
}
