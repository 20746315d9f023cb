package cz.paprsek.render.light;

import cz.paprsek.ray.Arrival;

/** Maps of the unit square to other figures, such that equal areas become equal areas. Only arithmetic and square roots: the same everywhere. */
final class Unit {
    private static final double QUARTER = Math.PI / 4;

    private Unit() {}

    /**
     * The square to the unit disc, squares about the middle to circles; x and y of the point are put into the arrival.
     *
     * @source Shirley and Chiu, A Low Distortion Map Between Disk and Square, Journal of Graphics Tools 2(3), 1997
     */
    static void disc(double u, double v, Arrival out) {
        double a = 2 * u - 1;
        double b = 2 * v - 1;
        if (a == 0 && b == 0) {
            out.x = 0;
            out.y = 0;
        } else if (Math.abs(a) > Math.abs(b)) {
            double angle = QUARTER * (b / a);
            out.x = a * cosine(angle);
            out.y = a * sine(angle);
        } else {
            double angle = QUARTER * (a / b);
            out.x = b * sine(angle);
            out.y = b * cosine(angle);
        }
    }

    /**
     * The square to the directions about one; the direction is put into the arrival.
     *
     * @param wx the middle, of length 1
     * @param depth 1 − cos of the angle between the middle and the rim
     * @return 1 − cos of the angle between the middle and the direction, to the last bits also where that is small
     * @source Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017
     */
    static double cap(double wx, double wy, double wz, double depth, double u, double v, Arrival out) {
        disc(u, v, out);
        double p = out.x;
        double q = out.y;
        double down = (p * p + q * q) * depth;
        double k = Math.sqrt(depth * (2 - down));
        double sign = wz < 0 ? -1 : 1;
        double a = -1 / (sign + wz);
        double b = wx * wy * a;
        p *= k;
        q *= k;
        out.x = (1 - down) * wx + p * (1 + sign * wx * wx * a) + q * b;
        out.y = (1 - down) * wy + p * sign * b + q * (sign + wy * wy * a);
        out.z = (1 - down) * wz - p * sign * wx - q * wy;
        return down;
    }

    /** Of an angle up to an eighth of a turn: Taylor's series, to the last bit or two. */
    private static double sine(double x) {
        double s = x * x;
        return x * (1 - s / 6 * (1 - s / 20 * (1 - s / 42 * (1 - s / 72 * (1 - s / 110 * (1 - s / 156 * (1 - s / 210)))))));
    }

    private static double cosine(double x) {
        double s = x * x;
        return 1 - s / 2 * (1 - s / 12 * (1 - s / 30 * (1 - s / 56 * (1 - s / 90 * (1 - s / 132 * (1 - s / 182 * (1 - s / 240)))))));
    }
}
