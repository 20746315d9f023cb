package cz.paprsek.shape;

import cz.paprsek.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.stream.DoubleStream;

/** Lines that draw primitives: silhouettes and edges. */
final class Outlines {
    private Outlines() {}

    /** The circle about a centre through centre + a and centre + b; an ellipse if these differ in length. */
    static Curve circle(Vec3 centre, Vec3 a, Vec3 b, int steps) {
        return closed(evenly(steps), angle -> centre.plus(a.times(StrictMath.cos(angle))).plus(b.times(StrictMath.sin(angle))));
    }

    /** The edges of a box: bottom, top and the four between. */
    static List<Curve> box(Vec3 min, Vec3 max) {
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

    /** A rectangle in a plane of constant z. */
    static Curve loop(double minX, double minY, double maxX, double maxY, double z) {
        return Curve.through(new Vec3(minX, minY, z), new Vec3(maxX, minY, z), new Vec3(maxX, maxY, z), new Vec3(minX, maxY, z),
                new Vec3(minX, minY, z));
    }

    /**
     * The silhouette of an ellipsoid: where the normal x/a² is perpendicular to the view. With x = a·s it is the great circle of the unit
     * ball perpendicular to the view divided by a.
     */
    static Curve ellipsoid(Vec3 axes, Vec3 along, int steps) {
        Vec3 view = new Vec3(along.x() / axes.x(), along.y() / axes.y(), along.z() / axes.z()).normalized();
        Vec3 a = view.cross(Math.abs(view.x()) < 0.7 ? Vec3.X : Vec3.Y).normalized();
        Vec3 b = view.cross(a);
        return circle(Vec3.ZERO, stretched(a, axes), stretched(b, axes), steps);
    }

    /**
     * The rims of a body of two discs about the y axis, and the straight silhouettes between. The side's normal at angle φ is
     * (cos φ, −k, sin φ) with k the slope of the radius; it is perpendicular to the view at φ₀ ± arccos(k·y/√(x² + z²)).
     */
    static List<Curve> round(double bottom, double top, double height, Vec3 along, int steps) {
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
    static List<Curve> ring(double major, double minor, Vec3 along, int steps) {
        double h = StrictMath.hypot(along.x(), along.z());
        double v = Math.copySign(Math.max(Math.abs(along.y()), 1e-9 * h), along.y());
        double towards = StrictMath.atan2(along.z(), along.x());
        double[] ends = evenly(steps).map(psi -> -v / h * StrictMath.tan(psi)).filter(c -> Math.abs(c) < 1).map(StrictMath::acos).toArray();
        double[] angles = DoubleStream.concat(evenly(steps),
                DoubleStream.concat(DoubleStream.of(ends), DoubleStream.of(ends).map(angle -> 2 * Math.PI - angle))).sorted().toArray();
        List<Curve> curves = new ArrayList<>();
        for (int side : new int[] {1, -1}) {
            curves.add(closed(DoubleStream.of(angles), theta -> {
                double psi = StrictMath.atan2(-h * StrictMath.cos(theta), v);
                double radius = major + side * minor * StrictMath.cos(psi);
                return new Vec3(radius * StrictMath.cos(towards + theta), side * minor * StrictMath.sin(psi), radius * StrictMath.sin(towards + theta));
            }));
        }
        return curves;
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
