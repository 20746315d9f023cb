package cz.paprsek.shape.outline;

import cz.paprsek.ray.Line;
import java.util.stream.DoubleStream;

/** A cubic Bézier curve; a quadratic one is one too. */
final class Bezier extends Piece {
    private final double ax;
    private final double ay;
    private final double bx;
    private final double by;

    Bezier(double x0, double y0, double ax, double ay, double bx, double by, double x1, double y1) {
        super(x0, y0, x1, y1);
        this.ax = ax;
        this.ay = ay;
        this.bx = bx;
        this.by = by;
    }

    @Override
    DoubleStream turns() {
        return DoubleStream.concat(turns(x0, ax, bx, x1), turns(y0, ay, by, y1)).filter(u -> u > 0 && u < 1);
    }

    private static DoubleStream turns(double p0, double p1, double p2, double p3) {
        double second = p0 - 2 * p1 + p2;
        double third = p3 - 3 * p2 + 3 * p1 - p0;
        double root = Math.sqrt(Math.max(0, second * second - third * (p1 - p0)));
        double q = -(second + Math.copySign(root, second));
        return DoubleStream.of(q / third, (p1 - p0) / q);
    }

    private static double at(double p0, double p1, double p2, double p3, double u) {
        double v = 1 - u;
        return v * v * v * p0 + 3 * v * v * u * p1 + 3 * v * u * u * p2 + u * u * u * p3;
    }

    private static double slope(double p0, double p1, double p2, double p3, double u) {
        double v = 1 - u;
        return 3 * (v * v * (p1 - p0) + 2 * v * u * (p2 - p1) + u * u * (p3 - p2));
    }

    @Override
    double x(double u) {
        return at(x0, ax, bx, x1, u);
    }

    @Override
    double y(double u) {
        return at(y0, ay, by, y1, u);
    }

    @Override
    double dx(double u) {
        return slope(x0, ax, bx, x1, u);
    }

    @Override
    double dy(double u) {
        return slope(y0, ay, by, y1, u);
    }

    @Override
    double[] controls() {
        return new double[] {x0, y0, ax, ay, bx, by, x1, y1};
    }

    /** The nearest of some points, and from there by halves. */
    @Override
    double parameter(double x, double y) {
        double best = 0;
        double step = 1.0 / 32;
        for (int i = 1; i <= 32; i++) {
            best = distance(i * step, x, y) < distance(best, x, y) ? i * step : best;
        }
        for (; step > 1e-12; step /= 2) {
            double below = Math.max(0, best - step);
            double above = Math.min(1, best + step);
            double here = distance(best, x, y);
            best = distance(below, x, y) < here ? below : distance(above, x, y) < here ? above : best;
        }
        return best;
    }

    private double distance(double u, double x, double y) {
        double ex = x(u) - x;
        double ey = y(u) - y;
        return ex * ex + ey * ey;
    }

    /** Between its turning points the side changes its sign once at most. */
    @Override
    void cross(double a, double b, double c, int face, Line out) {
        double g0 = a * x0 + b * y0 + c;
        double g1 = a * ax + b * ay + c;
        double g2 = a * bx + b * by + c;
        double g3 = a * x1 + b * y1 + c;
        if (isAbove(g0) == isAbove(g1) && isAbove(g1) == isAbove(g2) && isAbove(g2) == isAbove(g3)) {
            return;
        }
        double second = g0 - 2 * g1 + g2;
        double third = g3 - 3 * g2 + 3 * g1 - g0;
        // The slope is third·u² + 2·second·u + (g1 − g0), three times.
        double root = Math.sqrt(Math.max(0, second * second - third * (g1 - g0)));
        double q = -(second + Math.copySign(root, second));
        double first = q / third;
        double other = (g1 - g0) / q;
        double low = Math.min(first, other);
        double high = Math.max(first, other);
        double from = 0;
        boolean above = isAbove(g0);
        for (int i = 0; i < 3; i++) {
            double turn = i == 0 ? low : i == 1 ? high : 1;
            if (i < 2 && !(turn > from && turn < 1)) {
                continue;
            }
            boolean aboveNext = isAbove(i == 2 ? g3 : at(g0, g1, g2, g3, turn));
            if (above != aboveNext) {
                double u = root(g0, g1, g2, g3, from, turn, above);
                out.cross(b * x(u) - a * y(u), aboveNext ? face + 1 : face);
            }
            from = turn;
            above = aboveNext;
        }
    }

    private static double root(double g0, double g1, double g2, double g3, double from, double to, boolean aboveFrom) {
        double low = from;
        double high = to;
        double u = (low + high) / 2;
        while (u > low && u < high) {
            double g = at(g0, g1, g2, g3, u);
            if (isAbove(g) == aboveFrom) {
                low = u;
            } else {
                high = u;
            }
            double next = u - g / slope(g0, g1, g2, g3, u);
            if (Math.abs(next - u) <= 2e-16) {
                return u;
            }
            u = next > low && next < high ? next : (low + high) / 2;
        }
        return u;
    }
}
