package cz.paprsek.shape;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.height.HeightField;
import cz.paprsek.shape.mesh.Meshes;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** An example of every shape, and by a formula of its own whether a point lies inside, independent of the code that meets rays. */
public final class Examples {
    /** A line that crosses itself: the solid lies to its left, and then to its right. */
    private static final String CROSSED = "-1 -0.9 1 -0.9 1 0.9 -0.5 0.9 -0.5 -1.2 -1 -1.2";
    private static final String VASE = "0.3 -0.5 0.9 -0.5 0.5 0.2 0.9 0.9 0.3 0.9";

    /** In the units of the font, as fontTools 4.68 reads them; the second begins 1141 − 282 after the first. */
    private static final String LETTER_L = "201 1493 403 1493 403 170 1130 170 1130 0 201 0";
    private static final String LETTER_T = "-6 1493 1257 1493 1257 1323 727 1323 727 0 524 0 524 1323 -6 1323";

    private Examples() {}

    public static final Map<Class<? extends Shape>, Shape> ALL = inOrder(
            Map.entry(Sphere.class, new Sphere(1.3)),
            Map.entry(Block.class, new Block(new Vec3(-1, -0.5, 0.2), new Vec3(1, 0.7, 1.4))),
            Map.entry(Ellipsoid.class, new Ellipsoid(new Vec3(0.5, 1.2, 0.8))),
            Map.entry(Plane.class, new Plane()),
            Map.entry(Cylinder.class, new Cylinder(0.7, 1.5)),
            Map.entry(Cone.class, new Cone(1.1, 0.3, 1.4)),
            Map.entry(Torus.class, new Torus(1, 0.35)),
            Map.entry(Capsule.class, new Capsule(0.5, 0.9)),
            Map.entry(Prism.class, new Prism(6, 0.9, 1.2)),
            Map.entry(Superellipsoid.class, new Superellipsoid(new Vec3(1, 0.8, 1.2), 0.5, 1.4)),
            Map.entry(Extrude.class, new Extrude("", CROSSED, 0.8, 0, 0.5)),
            Map.entry(Lathe.class, new Lathe("", VASE, 360)),
            Map.entry(Text.class, Text.of("LT", 1.6, 1.4)),
            Map.entry(Isosurface.class, new Isosurface("hypot(hypot(x, y), z) - 1.2", new Vec3(-1.3, -1, -1.3), new Vec3(1.3, 1.3, 0.9))),
            Map.entry(HeightField.class, HeightField.of("peak.png", new Vec3(2.4, 1, 2)).read(HeightField.Content.of(3, 3, (column, row) -> column == 1 && row == 1 ? 1 : 0, 1.3))),
            Map.entry(Mesh.class, Mesh.of("cube.stl").read(new Mesh.Whole("cube.stl", Meshes.cube(0.9), Map.of()))),
            Map.entry(Rectangle.class, new Rectangle(-1, -0.5, 1.2, 0.9)),
            Map.entry(Disc.class, new Disc(1.1)),
            Map.entry(Csg.class, Csg.difference(
                    Operand.of(Csg.union(new Sphere(1), new Block(new Vec3(0, 0, 0), new Vec3(1.2, 1.2, 1.2)))),
                    Operand.of(new Torus(0.8, 0.3)).at(0.2, 0.4, 0), Operand.of(new Cone(0.5, 1.3)).rotated(40, 0, 20))));

    /** Examples of what shapes become with attributes that are seldom given. */
    public static final List<Shape> VARIANTS = List.of(
            new Block(new Vec3(-1, -0.5, 0.2), new Vec3(1, 0.7, 1.4), 0.3),
            new Block(new Vec3(-1, -0.5, -0.5), new Vec3(1, 0.5, 0.5), 0.5),
            new Cone(1.1, 0.3, 1.4, 4),
            new Cone(0, 0.9, 1.2, 7),
            new Torus(0.5, 0.8),
            new Extrude("", CROSSED, 0.8, 0, 1),
            new Extrude("", "-0.8 -0.6 0.9 -0.6 0.9 0.6 -0.8 0.6", 1, 0, 0),
            new Lathe("", "0 0 0.8 0 0.4 1", 360),
            new Superellipsoid(new Vec3(1, 1, 1), 2, 2),
            new Superellipsoid(new Vec3(1, 0.7, 1), 0.05, 0.2));

    /** In this order: that of {@code Map.of} differs from one run of Java to the next, and with it whatever is drawn at random for each shape. */
    @SafeVarargs
    private static Map<Class<? extends Shape>, Shape> inOrder(Map.Entry<Class<? extends Shape>, Shape>... examples) {
        Map<Class<? extends Shape>, Shape> all = new LinkedHashMap<>();
        for (Map.Entry<Class<? extends Shape>, Shape> example : examples) {
            all.put(example.getKey(), example.getValue());
        }
        return Collections.unmodifiableMap(all);
    }

    /** Below 0 inside, above 0 outside, in the solid's own space; grows about as fast as the distance. */
    public static double inside(Solid solid, Vec3 p) {
        double rho = Math.hypot(p.x(), p.z());
        if (solid instanceof Sphere s) {
            return p.length() - s.radius();
        } else if (solid instanceof Block b && b.rounding() > 0) {
            Vec3 q = p.minus(b.min().plus(b.max()).times(0.5));
            Vec3 h = b.max().minus(b.min()).times(0.5);
            double x = Math.abs(q.x()) - h.x() + b.rounding();
            double y = Math.abs(q.y()) - h.y() + b.rounding();
            double z = Math.abs(q.z()) - h.z() + b.rounding();
            return new Vec3(Math.max(x, 0), Math.max(y, 0), Math.max(z, 0)).length() + Math.min(0, largest(x, y, z)) - b.rounding();
        } else if (solid instanceof Cone c && c.sides() > 0) {
            return insideSides(c.sides(), c.radius(), c.topRadius(), c.height(), p);
        } else if (solid instanceof Block b) {
            return largest(b.min().x() - p.x(), p.x() - b.max().x(), b.min().y() - p.y(), p.y() - b.max().y(), b.min().z() - p.z(), p.z() - b.max().z());
        } else if (solid instanceof Ellipsoid e) {
            return new Vec3(p.x() / e.semiAxes().x(), p.y() / e.semiAxes().y(), p.z() / e.semiAxes().z()).length() - 1;
        } else if (solid instanceof Plane) {
            return p.y();
        } else if (solid instanceof Cylinder c) {
            return largest(rho - c.radius(), -p.y(), p.y() - c.height());
        } else if (solid instanceof Cone c) {
            return largest(rho - c.radius() - (c.topRadius() - c.radius()) * p.y() / c.height(), -p.y(), p.y() - c.height());
        } else if (solid instanceof Torus t) {
            return Math.hypot(rho - t.majorRadius(), p.y()) - t.minorRadius();
        } else if (solid instanceof Capsule c) {
            return Math.hypot(rho, p.y() - Math.max(0, Math.min(c.height(), p.y()))) - c.radius();
        } else if (solid instanceof Prism s) {
            return insideSides(s.sides(), s.radius(), s.radius(), s.height(), p);
        } else if (solid instanceof Superellipsoid s) {
            double east = norm(p.x() / s.semiAxes().x(), p.z() / s.semiAxes().z(), 2 / s.east());
            return norm(east, p.y() / s.semiAxes().y(), 2 / s.north()) - 1;
        } else if (solid instanceof Extrude e) {
            double size = Math.max(1e-300, 1 + (e.taper() - 1) * p.z() / e.height());
            return largest(size * beyond(e.points(), p.x() / size, p.y() / size), -p.z(), p.z() - e.height());
        } else if (solid instanceof Lathe l) {
            return beyond(l.points(), rho, p.y());
        } else if (solid instanceof Text t) {
            double unit = t.size() / 2048;
            return largest(unit * Math.min(beyond(LETTER_L, p.x() / unit, p.y() / unit), beyond(LETTER_T, p.x() / unit - 859, p.y() / unit)), -p.z(), p.z() - t.depth());
        } else if (solid instanceof Isosurface i) {
            return largest(p.length() - 1.2, i.min().y() - p.y(), p.z() - i.max().z());
        } else if (solid instanceof HeightField h) {
            double u = 2 * p.x() / h.extent().x();
            double v = 2 * p.z() / h.extent().z();
            double height = 1.3 * Math.max(0, 1 - largest(Math.abs(u), Math.abs(v), Math.abs(u - v)));
            return largest(p.y() - height, -p.y());
        } else if (solid instanceof Mesh) {
            return largest(Math.abs(p.x()), Math.abs(p.y()), Math.abs(p.z())) - 0.9;
        }
        Csg csg = (Csg) solid;
        double value = insideOperand(csg.operands().get(0), p);
        for (int i = 1; i < csg.operands().size(); i++) {
            double right = insideOperand(csg.operands().get(i), p);
            value = switch (csg.operation()) {
                case UNION -> Math.min(value, right);
                case DIFFERENCE -> Math.max(value, -right);
                case INTERSECTION -> Math.max(value, right);
            };
        }
        return value;
    }

    /** Of the sides that of which the middle is nearest counts. */
    private static double insideSides(int sides, double bottom, double top, double height, Vec3 p) {
        double each = 2 * Math.PI / sides;
        double angle = Math.atan2(p.z(), p.x());
        double fromMiddle = angle - (Math.floor(angle / each) + 0.5) * each;
        double radius = (bottom + (top - bottom) * p.y() / height) * Math.cos(Math.PI / sides);
        return largest(Math.hypot(p.x(), p.z()) * Math.cos(fromMiddle) - radius, -p.y(), p.y() - height);
    }

    /** How far a point lies from a polygon, below 0 if it is inside by the number of times that the polygon goes around it: it must be odd. */
    private static double beyond(String points, double x, double y) {
        double[] p = Arrays.stream(points.split(" ")).mapToDouble(Double::parseDouble).toArray();
        double nearest = Double.POSITIVE_INFINITY;
        double turned = 0;
        for (int i = 0; i < p.length; i += 2) {
            double ax = p[i] - x;
            double ay = p[i + 1] - y;
            double bx = p[(i + 2) % p.length] - x;
            double by = p[(i + 3) % p.length] - y;
            turned += Math.atan2(ax * by - ay * bx, ax * bx + ay * by);
            double along = Math.max(0, Math.min(1, -(ax * (bx - ax) + ay * (by - ay)) / ((bx - ax) * (bx - ax) + (by - ay) * (by - ay))));
            // A lathe's axis is no surface.
            if (!(p[i] == 0 && p[(i + 2) % p.length] == 0)) {
                nearest = Math.min(nearest, Math.hypot(ax + along * (bx - ax), ay + along * (by - ay)));
            }
        }
        return Math.round(turned / (2 * Math.PI)) % 2 != 0 ? -nearest : nearest;
    }

    private static double norm(double a, double b, double p) {
        return Math.pow(Math.pow(Math.abs(a), p) + Math.pow(Math.abs(b), p), 1 / p);
    }

    private static double insideOperand(Operand operand, Vec3 p) {
        return inside(operand.solid(), operand.placement().toParent().inverse().point(p));
    }

    private static double largest(double... values) {
        double most = Double.NEGATIVE_INFINITY;
        for (double value : values) {
            most = Math.max(most, value);
        }
        return most;
    }
}
