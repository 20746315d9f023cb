package cz.paprsek.shape.outline;

import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Sided;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** Lines that draw primitives: silhouettes and edges. */
public final class Drawn {
    private Drawn() {}

    /** The circle about a centre through centre + a and centre + b; an ellipse if these differ in length. */
    public static Curve circle(Vec3 centre, Vec3 a, Vec3 b, int steps) {
        return closed(evenly(steps), angle -> centre.plus(a.times(StrictMath.cos(angle))).plus(b.times(StrictMath.sin(angle))));
    }

    /** The edges of a box: bottom, top and the four between. */
    public static List<Curve> box(Vec3 min, Vec3 max) {
        List<Curve> edges = new ArrayList<>();
        edges.add(loop(min.x(), min.y(), max.x(), max.y(), min.z()));
        edges.add(loop(min.x(), min.y(), max.x(), max.y(), max.z()));
        for (double x : new double[] {min.x(), max.x()}) {
            for (double y : new double[] {min.y(), max.y()}) {
                edges.add(Curve.through(new Vec3(x, y, min.z()), new Vec3(x, y, max.z())));
            }
        }
        return edges;
    }

    /**
     * The silhouette of all that is not farther than a radius from a box: of directions n at right angles to the view, the corner that lies
     * farthest that way and r·n from there. And the rims of its flat parts.
     *
     * @param half from the middle of the box to its faces
     */
    public static List<Curve> roundedBox(Vec3 middle, Vec3 half, double radius, Vec3 along, int steps) {
        List<Curve> curves = new ArrayList<>();
        List<Vec3> directions = ellipsoid(Vec3.ONE, along, steps).points();
        List<Vec3> points = new ArrayList<>();
        for (int i = 0; i + 1 < directions.size(); i++) {
            Vec3 n = directions.get(i);
            points.add(middle.plus(corner(half, n, n)).plus(n.times(radius)));
            // From one corner to the next it goes straight, where n is at right angles to an edge.
            for (Vec3 turn : turns(n, directions.get(i + 1))) {
                points.add(middle.plus(corner(half, turn, n)).plus(turn.times(radius)));
                points.add(middle.plus(corner(half, turn, directions.get(i + 1))).plus(turn.times(radius)));
            }
        }
        points.add(points.get(0));
        curves.add(new Curve(points));
        for (int side : new int[] {-1, 1}) {
            curves.add(flat(middle.plus(new Vec3(side * (half.x() + radius), 0, 0)), new Vec3(0, half.y(), 0), new Vec3(0, 0, half.z())));
            curves.add(flat(middle.plus(new Vec3(0, side * (half.y() + radius), 0)), new Vec3(0, 0, half.z()), new Vec3(half.x(), 0, 0)));
            curves.add(flat(middle.plus(new Vec3(0, 0, side * (half.z() + radius))), new Vec3(half.x(), 0, 0), new Vec3(0, half.y(), 0)));
        }
        return curves;
    }

    /** The corner that lies farthest in a direction; where that is at right angles to an edge, the one on the side of another direction. */
    private static Vec3 corner(Vec3 half, Vec3 n, Vec3 otherwise) {
        return new Vec3(Math.copySign(half.x(), n.x() != 0 ? n.x() : otherwise.x()), Math.copySign(half.y(), n.y() != 0 ? n.y() : otherwise.y()),
                Math.copySign(half.z(), n.z() != 0 ? n.z() : otherwise.z()));
    }

    /** The directions between two where a coordinate changes its sign and is therefore 0, in turn. */
    private static List<Vec3> turns(Vec3 from, Vec3 to) {
        double[] at = {from.x() / (from.x() - to.x()), from.y() / (from.y() - to.y()), from.z() / (from.z() - to.z())};
        return IntStream.range(0, 3).filter(axis -> at[axis] > 0 && at[axis] < 1).boxed().sorted(Comparator.comparingDouble(axis -> at[axis])).map(axis -> {
            Vec3 n = from.plus(to.minus(from).times(at[axis]));
            return new Vec3(axis == 0 ? 0 : n.x(), axis == 1 ? 0 : n.y(), axis == 2 ? 0 : n.z()).normalized();
        }).toList();
    }

    private static Curve flat(Vec3 middle, Vec3 a, Vec3 b) {
        return Curve.through(middle.minus(a).minus(b), middle.plus(a).minus(b), middle.plus(a).plus(b), middle.minus(a).plus(b), middle.minus(a).minus(b));
    }

    /** The edges of a body of flat sides about the y axis, between two polygons. */
    public static List<Curve> sided(int sides, double bottom, double top, double height) {
        List<Curve> edges = new ArrayList<>();
        for (double y : new double[] {0, height}) {
            double radius = y == 0 ? bottom : top;
            if (radius > 0) {
                edges.add(new Curve(IntStream.rangeClosed(0, sides).mapToObj(i -> Sided.corner(i % sides, sides, radius, y)).toList()));
            }
        }
        for (int i = 0; i < sides; i++) {
            edges.add(Curve.through(Sided.corner(i, sides, bottom, 0), Sided.corner(i, sides, top, height)));
        }
        return edges;
    }

    /** A rectangle in a plane of constant z. */
    public static Curve loop(double minX, double minY, double maxX, double maxY, double z) {
        return Curve.through(new Vec3(minX, minY, z), new Vec3(maxX, minY, z), new Vec3(maxX, maxY, z), new Vec3(minX, maxY, z),
                new Vec3(minX, minY, z));
    }

    /**
     * The silhouette of an ellipsoid: where the normal x/a² is perpendicular to the view. With x = a·s it is the great circle of the unit
     * ball perpendicular to the view divided by a.
     */
    public static Curve ellipsoid(Vec3 axes, Vec3 along, int steps) {
        Vec3 view = new Vec3(along.x() / axes.x(), along.y() / axes.y(), along.z() / axes.z()).normalized();
        Vec3 a = view.cross(Math.abs(view.x()) < 0.7 ? Vec3.X : Vec3.Y).normalized();
        Vec3 b = view.cross(a);
        return circle(Vec3.ZERO, stretched(a, axes), stretched(b, axes), steps);
    }

    /**
     * The rims of a body of two discs about the y axis, and the straight silhouettes between. The side's normal at angle φ is
     * (cos φ, −k, sin φ) with k the slope of the radius; it is perpendicular to the view at φ₀ ± arccos(k·y/√(x² + z²)).
     */
    public static List<Curve> round(double bottom, double top, double height, Vec3 along, int steps) {
        List<Curve> curves = new ArrayList<>();
        for (double y : new double[] {0, height}) {
            double radius = y == 0 ? bottom : top;
            if (radius > 0) {
                curves.add(circle(new Vec3(0, y, 0), new Vec3(radius, 0, 0), new Vec3(0, 0, radius), steps));
            }
        }
        double flat = StrictMath.hypot(along.x(), along.z());
        double cosine = (top - bottom) / height * along.y() / flat;
        if (flat > 0 && Math.abs(cosine) < 1) {
            double towards = StrictMath.atan2(along.z(), along.x());
            for (double angle : new double[] {towards + StrictMath.acos(cosine), towards - StrictMath.acos(cosine)}) {
                double x = StrictMath.cos(angle);
                double z = StrictMath.sin(angle);
                curves.add(Curve.through(new Vec3(bottom * x, 0, bottom * z), new Vec3(top * x, height, top * z)));
            }
        }
        return curves;
    }

    /**
     * The two silhouettes of a ring about the y axis. Around the ring at angle θ from the view, the tube's normal, at angle ψ from the
     * outward direction, is perpendicular to the view where tan ψ = −(h/v)·cos θ, with h and v the parts of the view along the ring's plane
     * and across. Seen almost along its plane, ψ turns fast at the two ends, and so points are set evenly in ψ too.
     */
    public static List<Curve> ring(double major, double minor, Vec3 along, int steps) {
        double h = StrictMath.hypot(along.x(), along.z());
        double v = Math.copySign(Math.max(Math.abs(along.y()), 1e-9 * h), along.y());
        double towards = StrictMath.atan2(along.z(), along.x());
        double[] ends = evenly(steps).map(psi -> -v / h * StrictMath.tan(psi)).filter(c -> Math.abs(c) < 1).map(StrictMath::acos).toArray();
        double[] angles = DoubleStream.concat(evenly(steps),
                DoubleStream.concat(DoubleStream.of(ends), DoubleStream.of(ends).map(angle -> 2 * Math.PI - angle))).sorted().toArray();
        List<Curve> curves = new ArrayList<>();
        for (int side : new int[] {1, -1}) {
            List<Vec3> points = new ArrayList<>();
            for (int i = 0; i <= angles.length; i++) {
                double theta = angles[i % angles.length];
                double psi = StrictMath.atan2(-h * StrictMath.cos(theta), v);
                double radius = major + side * minor * StrictMath.cos(psi);
                if (radius >= 0) {
                    points.add(new Vec3(radius * StrictMath.cos(towards + theta), side * minor * StrictMath.sin(psi), radius * StrictMath.sin(towards + theta)));
                } else {
                    // Beyond the axis the tube of a ring without a hole runs within the ring.
                    flush(points, curves);
                }
            }
            flush(points, curves);
        }
        return curves;
    }

    private static void flush(List<Vec3> points, List<Curve> into) {
        if (points.size() > 1) {
            into.add(new Curve(points));
        }
        points.clear();
    }

    private static Curve closed(DoubleStream angles, DoubleFunction<Vec3> point) {
        List<Vec3> points = new ArrayList<>(angles.mapToObj(point).toList());
        points.add(points.get(0));
        return new Curve(points);
    }

    private static DoubleStream evenly(int steps) {
        return DoubleStream.iterate(0, i -> i + 1).limit(steps).map(i -> i * 2 * Math.PI / steps);
    }

    private static Vec3 stretched(Vec3 v, Vec3 by) {
        return new Vec3(v.x() * by.x(), v.y() * by.y(), v.z() * by.z());
    }
}
