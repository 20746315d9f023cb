package cz.paprsek.render.sample;

/** Scratch of one worker: the light of a pixel's samples so far, linear, and what it comes to. */
public final class PixelSums {
    private static final int CHANNELS = 3;
    /** Below nothing, light is not shown. */
    private static final double DARKEST = 0;

    private final double[] light;
    private final boolean[] negative;
    /** What a filter that is negative in places weighs in all, if that is counted as if it were positive; 1 for others. */
    private final double mass;
    private final Target target;
    private int count;

    /** What {@link #mean} has found. */
    public double red;
    public double green;
    public double blue;
    /** The weight of each sample that the filter adds, and of each that it takes away, in what was found. */
    public double weight;
    public double negativeWeight;

    PixelSums(int most, double mass, Target target) {
        light = new double[CHANNELS * most];
        negative = new boolean[most];
        this.mass = mass;
        this.target = target;
    }

    public void clear() {
        count = 0;
    }

    public void add(double r, double g, double b, boolean isNegative) {
        light[CHANNELS * count] = r;
        light[CHANNELS * count + 1] = g;
        light[CHANNELS * count + 2] = b;
        negative[count++] = isNegative;
    }

    public int count() {
        return count;
    }

    /** Whether the filter takes away what a sample brings. */
    public boolean isNegative(int sample) {
        return negative[sample];
    }

    /** How far the samples are apart in a channel. */
    double range(int channel) {
        double least = light[channel];
        double most = light[channel];
        for (int i = 1; i < count; i++) {
            least = Math.min(least, light[CHANNELS * i + channel]);
            most = Math.max(most, light[CHANNELS * i + channel]);
        }
        return most - least;
    }

    /** Whether the light is known as well as is wished. */
    boolean areNear() {
        return target.isMet(this);
    }

    /** Finds the pixel's light. */
    public void mean() {
        mean(0, count);
    }

    /**
     * Finds what the samples from one to another, exclusive, come to: with all n weights alike their mean. Else, with s = ±1 the sign of the filter
     * and m its mass, Σ s·m·L/n and, so that an even brightness stays what it is, the mean of L times what the weights lack to 1.
     */
    void mean(int from, int to) {
        int n = to - from;
        int below = 0;
        double addR = 0;
        double addG = 0;
        double addB = 0;
        double takeR = 0;
        double takeG = 0;
        double takeB = 0;
        for (int i = from; i < to; i++) {
            double r = light[CHANNELS * i];
            double g = light[CHANNELS * i + 1];
            double b = light[CHANNELS * i + 2];
            if (negative[i]) {
                below++;
                takeR += r;
                takeG += g;
                takeB += b;
            } else {
                addR += r;
                addG += g;
                addB += b;
            }
        }
        double share = 1.0 / n;
        if (below == 0) {
            weight = share;
            negativeWeight = share;
            red = addR * share;
            green = addG * share;
            blue = addB * share;
        } else {
            double lacking = (1 - mass * share * (n - 2 * below)) * share;
            weight = lacking + mass * share;
            negativeWeight = lacking - mass * share;
            red = Math.max(DARKEST, addR * weight + takeR * negativeWeight);
            green = Math.max(DARKEST, addG * weight + takeG * negativeWeight);
            blue = Math.max(DARKEST, addB * weight + takeB * negativeWeight);
        }
    }
}
