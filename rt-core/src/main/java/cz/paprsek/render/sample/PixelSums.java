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
    private final int together;
    private final Sum sums = new Sum();
    private final Sum pass = new Sum();
    private int count;

    /** What {@link #mean} has found. */
    public double red;
    public double green;
    public double blue;
    /** The weight of each sample that the filter adds, and of each that it takes away, in what was found. */
    public double weight;
    public double negativeWeight;

    /** @param together how many samples are summed before their sum is added to the others' */
    PixelSums(int most, int together, double mass, Target target) {
        this.together = together;
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
        sums.clear();
        for (int i = from; i < to; i += together) {
            pass.clear();
            for (int k = i; k < Math.min(to, i + together); k++) {
                pass.add(light[CHANNELS * k], light[CHANNELS * k + 1], light[CHANNELS * k + 2], negative[k]);
            }
            sums.add(pass);
        }
        int below = sums.below;
        double share = 1.0 / n;
        if (below == 0) {
            weight = share;
            negativeWeight = share;
            red = sums.addR * share;
            green = sums.addG * share;
            blue = sums.addB * share;
        } else {
            double lacking = (1 - mass * share * (n - 2 * below)) * share;
            weight = lacking + mass * share;
            negativeWeight = lacking - mass * share;
            red = Math.max(DARKEST, sums.addR * weight + sums.takeR * negativeWeight);
            green = Math.max(DARKEST, sums.addG * weight + sums.takeG * negativeWeight);
            blue = Math.max(DARKEST, sums.addB * weight + sums.takeB * negativeWeight);
        }
    }

    /** Light that the filter adds, and light that it takes away. */
    private static final class Sum {
        private int below;
        private double addR;
        private double addG;
        private double addB;
        private double takeR;
        private double takeG;
        private double takeB;

        void clear() {
            below = 0;
            addR = 0;
            addG = 0;
            addB = 0;
            takeR = 0;
            takeG = 0;
            takeB = 0;
        }

        void add(double r, double g, double b, boolean isNegative) {
            if (isNegative) {
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

        void add(Sum other) {
            below += other.below;
            addR += other.addR;
            addG += other.addG;
            addB += other.addB;
            takeR += other.takeR;
            takeG += other.takeG;
            takeB += other.takeB;
        }
    }
}
