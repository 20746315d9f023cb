package cz.paprsek.shape;

/**
 * Sign changes of s⁴ + c₂s² + c₁s + c₀ in an interval about 0, found between the turning points of the polynomial. A double root counts as
 * two sign changes or none, never as one, so that a solid's boundaries always come in pairs.
 */
final class Quartic {
    private Quartic() {}

    /**
     * Pushes a boundary at (middle + s)·unit for every sign change s between −reach and reach, in rising order. At both ends the
     * polynomial counts as positive, whatever rounding says: the interval reaches out of the body.
     *
     * @param breaks scratch for three numbers
     */
    static void roots(
            double c2, double c1, double c0, double reach, double middle, double unit, int part, double[] breaks, Spans out) {
        int count = turningPoints(c2, c1, reach, breaks);
        double low = -reach;
        boolean inside = false;
        for (int i = 0; i <= count; i++) {
            double high = i < count ? breaks[i] : reach;
            boolean insideNext = i < count && value(1, 0, c2, c1, c0, high) < 0;
            if (inside != insideNext) {
                out.add((middle + root(1, 0, c2, c1, c0, low, high, inside)) * unit, part, 0);
            }
            low = high;
            inside = insideNext;
        }
    }

    /** Fills {@code breaks} with the roots of the derivative 4s³ + 2c₂s + c₁ between −reach and reach, in rising order. */
    private static int turningPoints(double c2, double c1, double reach, double[] breaks) {
        double bend = c2 < 0 ? Math.min(Math.sqrt(-c2 / 6), reach) : 0;
        double low = -reach;
        int count = 0;
        for (int i = 0; i < 3; i++) {
            double high = i == 0 ? -bend : i == 1 ? bend : reach;
            boolean negative = value(0, 4, 0, 2 * c2, c1, low) < 0;
            if (high > low && negative != value(0, 4, 0, 2 * c2, c1, high) < 0) {
                breaks[count++] = root(0, 4, 0, 2 * c2, c1, low, high, negative);
            }
            low = high;
        }
        return count;
    }

    private static double value(double c4, double c3, double c2, double c1, double c0, double s) {
        return (((c4 * s + c3) * s + c2) * s + c1) * s + c0;
    }

    /** The sign change between low and high by Newton's method kept inside a shrinking bracket. */
    private static double root(
            double c4, double c3, double c2, double c1, double c0, double low, double high, boolean negativeAtLow) {
        double a = low;
        double b = high;
        double s = (a + b) / 2;
        while (s > a && s < b) {
            double f = value(c4, c3, c2, c1, c0, s);
            if (f == 0) {
                return s;
            }
            if (f < 0 == negativeAtLow) {
                a = s;
            } else {
                b = s;
            }
            double step = f / (((4 * c4 * s + 3 * c3) * s + 2 * c2) * s + c1);
            if (Math.abs(step) <= Math.ulp(s)) {
                return s;
            }
            s -= step;
            if (!(s > a && s < b)) {
                s = (a + b) / 2;
            }
        }
        return s;
    }
}
