package cz.paprsek.render.eye;

/**
 * Brings a square to a disc: equal areas to equal areas, neighbours to neighbours, the middle to the middle.
 *
 * @source Shirley, Chiu, A Low Distortion Map Between Disk and Square, Journal of Graphics Tools 2(3), 1997
 */
final class Disc {
    private static final double QUARTER = Math.PI / 4;

    private Disc() {}

    /** The x of the point of the disc of radius 1 for a point of the square from 0 to 1. */
    static double x(double u, double v) {
        double a = 2 * u - 1;
        double b = 2 * v - 1;
        return a * a > b * b ? a * StrictMath.cos(QUARTER * b / a) : b == 0 ? 0 : b * StrictMath.sin(QUARTER * a / b);
    }

    /** The y likewise. */
    static double y(double u, double v) {
        return x(v, u);
    }
}
