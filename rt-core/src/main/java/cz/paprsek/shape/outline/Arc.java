package cz.paprsek.shape.outline;

import cz.paprsek.ray.Line;
import java.util.stream.DoubleStream;

/** A part of an ellipse, a quarter at most: m + p·cos θ + q·sin θ from one θ to a larger one. */
final class Arc extends Piece {
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
