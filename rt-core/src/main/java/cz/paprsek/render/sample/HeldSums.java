package cz.paprsek.render.sample;

/** The samples of a pixel each by itself: few enough to be held, and judged by how far any of them are apart. */
final class HeldSums extends PixelSums {
    private static final int CHANNELS = 3;
    /** How many groups of neighbours samples are judged by. */
    static final int GROUPS = 4;

    private final double[] light;
    private final boolean[] negative;
    private final Target target;
    private final Sum sums = new Sum();
    private int count;

    HeldSums(int most, double mass, Target target) {
        super(mass);
        light = new double[CHANNELS * most];
        negative = new boolean[most];
        this.target = target;
    }

    @Override
    public void clear() {
        count = 0;
    }

    @Override
    public void add(double r, double g, double b, boolean isNegative) {
        light[CHANNELS * count] = r;
        light[CHANNELS * count + 1] = g;
        light[CHANNELS * count + 2] = b;
        negative[count++] = isNegative;
    }

    @Override
    public int count() {
        return count;
    }

    @Override
    boolean areNear() {
        return target.isMet(halfWidth());
    }

    @Override
    public double interval() {
        return count < Target.FEWEST ? Target.UNKNOWN : halfWidth();
    }

    private double halfWidth() {
        for (int i = 0; i < GROUPS; i++) {
            mean(i * count / GROUPS, (i + 1) * count / GROUPS);
            target.group(i, this);
        }
        // The groups may happen to agree: one sample on the wrong side of an edge is always thought possible.
        double share = 1.0 / count;
        return target.halfWidth(share * range(0), share * range(1), share * range(2));
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

    @Override
    public void mean() {
        mean(0, count);
    }

    /** Finds what the samples from one to another, exclusive, come to. */
    private void mean(int from, int to) {
        sums.clear();
        for (int i = from; i < to; i++) {
            sums.add(light[CHANNELS * i], light[CHANNELS * i + 1], light[CHANNELS * i + 2], negative[i]);
        }
        mean(sums, to - from);
    }
}
