package cz.paprsek.shape.field;

import cz.paprsek.formula.Function;

/** The sine of an interval of degrees, as {@link Enclosed} has it: each end is asked for once, though both bounds depend on it. */
final class Wave {
    private static final double QUARTER = 90;
    private static final double WHOLE = 360;

    private Wave() {}

    /** The sine of a + ahead, and its slope, the sine of 90 degrees more. */
    static void of(double[] r, int a, double ahead, int out) {
        double from = r[a + Enclosed.LOW] + ahead;
        double to = r[a + Enclosed.HIGH] + ahead;
        // Of a whole turn no end tells anything.
        boolean isWide = !(to - from < WHOLE);
        double first = isWide ? 0 : Function.SIN.of(from, 0, 0);
        double last = isWide ? 0 : Function.SIN.of(to, 0, 0);
        double slopeFirst = isWide ? 0 : Function.SIN.of(from + QUARTER, 0, 0);
        double slopeLast = isWide ? 0 : Function.SIN.of(to + QUARTER, 0, 0);
        double slow = Enclosed.lower(Enclosed.DEGREE * extreme(from + QUARTER, to + QUARTER, slopeFirst, slopeLast, -1));
        double fast = Enclosed.upper(Enclosed.DEGREE * extreme(from + QUARTER, to + QUARTER, slopeFirst, slopeLast, 1));
        double slowest = r[a + Enclosed.SLOWEST];
        double fastest = r[a + Enclosed.FASTEST];
        Enclosed.set(r, out, extreme(from, to, first, last, -1), extreme(from, to, first, last, 1), Enclosed.least(slow, fast, slowest, fastest), Enclosed.most(slow, fast, slowest, fastest));
    }

    /** The extreme over an interval of which both ends are known, with what rounding of the angle does to it. */
    private static double extreme(double low, double high, double first, double last, int sign) {
        double slack = 1e-14 * (1 + Enclosed.largest(low, high));
        double turns = Math.floor((high + slack - QUARTER * sign) / WHOLE);
        if (!(high - low < WHOLE) || turns * WHOLE + QUARTER * sign >= low - slack) {
            return sign;
        }
        return sign > 0 ? Math.min(1, Math.max(first, last) + slack) : Math.max(-1, Math.min(first, last) - slack);
    }
}
