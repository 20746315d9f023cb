package cz.paprsek.render.sample;

/** Scratch of one worker: the light of a pixel's samples so far, linear, and what it comes to. */
public abstract class PixelSums {
    /** Below nothing, light is not shown. */
    private static final double DARKEST = 0;

    /** What a filter that is negative in places weighs in all, if that is counted as if it were positive; 1 for others. */
    private final double mass;

    /** What {@link #mean} has found. */
    public double red;
    public double green;
    public double blue;
    /** Whether one of the samples of this pass has met anything: what is black then may be lit by what is rarely found. */
    public boolean meets;
    /** The weight of each sample that the filter adds, and of each that it takes away, in what was found. */
    public double weight;
    public double negativeWeight;

    PixelSums(double mass) {
        this.mass = mass;
    }

    public abstract void clear();

    /** @param isNegative whether the filter takes away what the sample brings */
    public abstract void add(double r, double g, double b, boolean isNegative);

    public abstract int count();

    /** Finds the pixel's light. */
    public abstract void mean();

    /** Whether the light is known as well as is wished. */
    abstract boolean areNear();

    /** How far the value that is shown may be from the true one, 0 to 1; below 0 if that cannot be trusted. Of judged samples only. */
    public abstract double interval();

    /**
     * Finds what n samples come to: with all n weights alike their mean. Else, with s = ±1 the sign of the filter and m its mass, Σ s·m·L/n and, so
     * that an even brightness stays what it is, the mean of L times what the weights lack to 1.
     */
    final void mean(Sum sums, int n) {
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
    static final class Sum {
        int below;
        double addR;
        double addG;
        double addB;
        double takeR;
        double takeG;
        double takeB;

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
    }
}
