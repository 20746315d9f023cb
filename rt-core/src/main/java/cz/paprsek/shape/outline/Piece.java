package cz.paprsek.shape.outline;

import cz.paprsek.ray.Line;
import java.util.stream.DoubleStream;

/**
 * A piece of an outline, from u = 0 to u = 1. A straight line a·x + b·y + c = 0 crosses it where the left side changes its sign; at its ends that
 * is worked out by the same arithmetic as for the neighbours, so that no line slips through between two pieces or is counted by both.
 */
abstract class Piece {
    final double x0;
    final double y0;
    final double x1;
    final double y1;

    Piece(double x0, double y0, double x1, double y1) {
        this.x0 = x0;
        this.y0 = y0;
        this.x1 = x1;
        this.y1 = y1;
    }

    abstract double x(double u);

    abstract double y(double u);

    /** How fast x changes with u. */
    abstract double dx(double u);

    abstract double dy(double u);

    /** The u of a point of the piece. */
    abstract double parameter(double x, double y);

    /**
     * Notes where the line crosses it, by how far along the line that is: b·x − a·y.
     *
     * @param face that is crossed if the sign falls along the piece; if it rises it is the next number
     */
    abstract void cross(double a, double b, double c, int face, Line out);

    /** As cubic Bézier curves, four points each, x and y in turn, one after the other the way the outline runs. */
    abstract double[] controls();

    /** Whether the outline runs from its end to its beginning. */
    boolean isBackward() {
        return false;
    }

    /** Where x or y turns round within the piece. */
    DoubleStream turns() {
        return DoubleStream.empty();
    }

    static boolean isAbove(double side) {
        return side >= 0;
    }

    /** From one corner to the next. */
    static final class Straight extends Piece {
        Straight(double x0, double y0, double x1, double y1) {
            super(x0, y0, x1, y1);
        }

        @Override
        double x(double u) {
            return x0 + u * (x1 - x0);
        }

        @Override
        double y(double u) {
            return y0 + u * (y1 - y0);
        }

        @Override
        double dx(double u) {
            return x1 - x0;
        }

        @Override
        double dy(double u) {
            return y1 - y0;
        }

        @Override
        double[] controls() {
            return new double[] {x0, y0, x(1.0 / 3), y(1.0 / 3), x(2.0 / 3), y(2.0 / 3), x1, y1};
        }

        @Override
        double parameter(double x, double y) {
            double dx = x1 - x0;
            double dy = y1 - y0;
            return Math.max(0, Math.min(1, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)));
        }

        @Override
        void cross(double a, double b, double c, int face, Line out) {
            double from = a * x0 + b * y0 + c;
            double to = a * x1 + b * y1 + c;
            if (isAbove(from) != isAbove(to)) {
                double u = from / (from - to);
                double start = b * x0 - a * y0;
                out.cross(start + u * (b * (x1 - x0) - a * (y1 - y0)), isAbove(to) ? face + 1 : face);
            }
        }
    }

    /** A part of an ellipse, a quarter at most: m + p·cos θ + q·sin θ from one θ to a larger one. */
    static final class Arc extends Piece {
        /** The largest angle that is taken for one Bézier curve: it is off by 7e-8 of the radius then, and that goes by the sixth power. */
        private static final double LARGEST = Math.PI / 8;

        private final double mx;
        private final double my;
        private final double px;
        private final double py;
        private final double qx;
        private final double qy;
        private final double from;
        private final double to;
        private final boolean isBackward;
        /** The ends on the unit circle. */
        private final double cos0;
        private final double sin0;
        private final double cos1;
        private final double sin1;

        /**
         * An arc.
         *
         * @param ends x0, y0, x1 and y1, which neighbours have too
         * @param from θ at u = 0, radians
         * @param to θ at u = 1, a larger one
         * @param isBackward whether the outline runs from the second end to the first
         */
        Arc(double[] ends, double mx, double my, double px, double py, double qx, double qy, double from, double to, boolean isBackward) {
            super(ends[0], ends[1], ends[2], ends[3]);
            this.mx = mx;
            this.my = my;
            this.px = px;
            this.py = py;
            this.qx = qx;
            this.qy = qy;
            this.from = from;
            this.to = to;
            this.isBackward = isBackward;
            cos0 = StrictMath.cos(from);
            sin0 = StrictMath.sin(from);
            cos1 = StrictMath.cos(to);
            sin1 = StrictMath.sin(to);
        }

        @Override
        boolean isBackward() {
            return isBackward;
        }

        @Override
        DoubleStream turns() {
            return DoubleStream.of(StrictMath.atan2(qx, px), StrictMath.atan2(qy, py))
                    .flatMap(angle -> DoubleStream.of(-3, -2, -1, 0, 1, 2, 3).map(half -> (angle + half * Math.PI - from) / (to - from))).filter(u -> u > 0 && u < 1);
        }

        private double angle(double u) {
            return from + u * (to - from);
        }

        @Override
        double x(double u) {
            return mx + px * StrictMath.cos(angle(u)) + qx * StrictMath.sin(angle(u));
        }

        @Override
        double y(double u) {
            return my + py * StrictMath.cos(angle(u)) + qy * StrictMath.sin(angle(u));
        }

        @Override
        double dx(double u) {
            return (to - from) * (qx * StrictMath.cos(angle(u)) - px * StrictMath.sin(angle(u)));
        }

        @Override
        double dy(double u) {
            return (to - from) * (qy * StrictMath.cos(angle(u)) - py * StrictMath.sin(angle(u)));
        }

        /**
         * Near enough to be one for all who look at it.
         *
         * @source Goldapp, Approximation of circular arcs by cubic polynomials, Computer Aided Geometric Design 8, 1991
         */
        @Override
        double[] controls() {
            int parts = (int) Math.ceil((to - from) / LARGEST);
            // How far the inner points lie along the tangents.
            double reach = 4.0 / 3 * StrictMath.tan((to - from) / parts / 4) / (to - from);
            double[] points = new double[8 * parts];
            for (int i = 0; i < parts; i++) {
                double first = (double) (isBackward ? parts - i : i) / parts;
                double last = (double) (isBackward ? parts - i - 1 : i + 1) / parts;
                double way = isBackward ? -reach : reach;
                double[] four = {endX(first), endY(first), endX(first) + way * dx(first), endY(first) + way * dy(first), endX(last) - way * dx(last), endY(last) - way * dy(last), endX(last), endY(last)};
                System.arraycopy(four, 0, points, 8 * i, four.length);
            }
            return points;
        }

        /** A point's x; at the ends that which the neighbours have. */
        private double endX(double u) {
            return u == 0 ? x0 : u == 1 ? x1 : x(u);
        }

        private double endY(double u) {
            return u == 0 ? y0 : u == 1 ? y1 : y(u);
        }

        @Override
        double parameter(double x, double y) {
            double side = px * qy - py * qx;
            double cos = ((x - mx) * qy - (y - my) * qx) / side;
            double sin = (px * (y - my) - py * (x - mx)) / side;
            // From the middle of the arc, so that no turn lies between.
            double middle = (from + to) / 2;
            double cm = StrictMath.cos(middle);
            double sm = StrictMath.sin(middle);
            double beyond = StrictMath.atan2(sin * cm - cos * sm, cos * cm + sin * sm);
            return Math.max(0, Math.min(1, (middle + beyond - from) / (to - from)));
        }

        @Override
        void cross(double a, double b, double c, int face, Line out) {
            double gm = a * mx + b * my + c;
            double gp = a * px + b * py;
            double gq = a * qx + b * qy;
            boolean above0 = isAbove(a * x0 + b * y0 + c);
            boolean above1 = isAbove(a * x1 + b * y1 + c);
            double square = gp * gp + gq * gq;
            if (above0 == above1) {
                // It may bulge over the line: then the point farthest that way lies between the ends.
                double way = above0 ? -1 : 1;
                boolean isBetween = way * (cos0 * gq - sin0 * gp) >= 0 && way * (gp * sin1 - gq * cos1) >= 0;
                if (!isBetween || isAbove(gm + way * Math.sqrt(square)) == above0) {
                    return;
                }
            }
            double half = Math.sqrt(Math.max(0, 1 - gm * gm / square)) / Math.sqrt(square);
            double cos = -gm * gp / square;
            double sin = -gm * gq / square;
            double wm = b * mx - a * my;
            double wp = b * px - a * py;
            double wq = b * qx - a * qy;
            if (!above0 || above0 == above1) {
                out.cross(wm + wp * (cos + half * gq) + wq * (sin - half * gp), face + 1);
            }
            if (above0 || above0 == above1) {
                out.cross(wm + wp * (cos - half * gq) + wq * (sin + half * gp), face);
            }
        }
    }

    /** A cubic Bézier curve; a quadratic one is one too. */
    static final class Bezier extends Piece {
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
}
