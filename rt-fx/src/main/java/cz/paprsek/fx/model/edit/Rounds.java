package cz.paprsek.fx.model.edit;

/** Round numbers, as hands like them: steps of grids, and the multiples of these. */
public final class Rounds {
    /** How near fine lines of a grid may come, pixels. */
    private static final double CLOSEST = 14;

    private Rounds() {}

    /**
     * The distance of fine lines: 1, 2 or 5 times a power of ten, scene units.
     *
     * @param scale pixels per scene unit
     */
    public static double step(double scale) {
        double least = CLOSEST / scale;
        double power = Math.pow(10, Math.floor(Math.log10(least)));
        for (double factor : new double[] {1, 2, 5}) {
            if (factor * power >= least * (1 - 1e-9)) {
                return factor * power;
            }
        }
        return 10 * power;
    }

    /** The nearest multiple of the step, as the nearest decimal. */
    public static double toGrid(double value, double step) {
        double count = Math.rint(value / step);
        // A step below 1 is no binary fraction, but its reciprocal is a whole number; 0 is added to make −0 into 0.
        return (step < 1 ? count / Math.rint(1 / step) : count * step) + 0.0;
    }
}
