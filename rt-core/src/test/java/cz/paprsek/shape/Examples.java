package cz.paprsek.shape;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.mesh.Meshes;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/** An example of every shape, and by a formula of its own whether a point lies inside, independent of the code that meets rays. */
public final class Examples {
    private Examples() {}

    public static final Map<Class<? extends Shape>, Shape> ALL = inOrder(
            Map.entry(Sphere.class, new Sphere(1.3)),
            Map.entry(Block.class, new Block(new Vec3(-1, -0.5, 0.2), new Vec3(1, 0.7, 1.4))),
            Map.entry(Ellipsoid.class, new Ellipsoid(new Vec3(0.5, 1.2, 0.8))),
            Map.entry(Plane.class, new Plane()),
            Map.entry(Cylinder.class, new Cylinder(0.7, 1.5)),
            Map.entry(Cone.class, new Cone(1.1, 0.3, 1.4)),
            Map.entry(Torus.class, new Torus(1, 0.35)),
            Map.entry(Mesh.class, Mesh.of("cube.stl").read(new Mesh.Whole("cube.stl", Meshes.cube(0.9), Map.of()))),
            Map.entry(Rectangle.class, new Rectangle(-1, -0.5, 1.2, 0.9)),
            Map.entry(Disc.class, new Disc(1.1)),
            Map.entry(Csg.class, Csg.difference(
                    Operand.of(Csg.union(new Sphere(1), new Block(new Vec3(0, 0, 0), new Vec3(1.2, 1.2, 1.2)))),
                    Operand.of(new Torus(0.8, 0.3)).at(0.2, 0.4, 0), Operand.of(new Cone(0.5, 1.3)).rotated(40, 0, 20))));

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
