package cz.paprsek.shape.placed;

/** Turning points of s⁴ + c₂s² + c₁s + c₀, whatever c₀. */
public final class Quartic {
    private Quartic() {}

    /** Fills {@code breaks} with the roots of the derivative 4s³ + 2c₂s + c₁ between −reach and reach, in rising order. */
    public static int turningPoints(double c2, double c1, double reach, double[] breaks) {
        double bend = c2 < 0 ? Math.min(Math.sqrt(-c2 / 6), reach) : 0;
        double low = -reach;
        int count = 0;
        for (int i = 0; i < 3; i++) {
            double high = i == 0 ? -bend : i == 1 ? bend : reach;
            boolean negative = slope(c2, c1, low) < 0;
            if (high > low && negative != slope(c2, c1, high) < 0) {
                breaks[count++] = root(c2, c1, low, high, negative);
            }
            low = high;
        }
        return count;
    }

    private static double slope(double c2, double c1, double s) {
        return (4 * s * s + 2 * c2) * s + c1;
    }

    /** The sign change between low and high by Newton's method kept inside a shrinking bracket. */
    private static double root(double c2, double c1, double low, double high, boolean negativeAtLow) {
        double a = low;
        double b = high;
        double s = (a + b) / 2;
        while (s > a && s < b) {
            double f = slope(c2, c1, s);
            if (f == 0) {
                return s;
            }
            if (f < 0 == negativeAtLow) {
                a = s;
            } else {
                b = s;
            }
            double step = f / (12 * s * s + 2 * c2);
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
