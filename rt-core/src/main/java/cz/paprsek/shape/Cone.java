package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.outline.Drawn;
import cz.paprsek.shape.placed.LocalConvex;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Sided;
import cz.paprsek.shape.placed.Volume;
import java.util.List;

/**
 * A closed cone about the y axis: {@code radius} at y = 0, {@code topRadius} at y = height; pointed if that is 0.
 *
 * @param sides 0 if it is round; else how many flat sides it has, whose corners lie at the radii, one towards +x
 */
@Element("A closed cone about its y axis, from y = 0.")
public record Cone(
        @Attribute(value = Kind.NOT_NEGATIVE, means = "At y = 0") double radius,
        @Attribute(value = Kind.NOT_NEGATIVE, means = "At y = height; not both radii 0", otherwise = "0") double topRadius,
        @Attribute(value = Kind.POSITIVE, means = "Above 0", example = "1") double height,
        @Attribute(value = Kind.SIDES_OR_NONE, means = "How many flat ones, as of a pyramid, with a corner towards +x; 0 if it is round", otherwise = "0") int sides) implements Solid {
    public Cone {
        Require.sizeOrZero("cone radius", radius);
        Require.sizeOrZero("cone top-radius", topRadius);
        Require.that(radius > 0 || topRadius > 0, "cone radius and top-radius must not both be 0");
        Require.size("cone height", height);
        Require.that(sides == 0 || (sides >= Kind.SIDES.least() && sides <= Kind.SIDES.most()), "cone sides must be " + Kind.SIDES_OR_NONE.words() + ", but is " + sides);
    }

    /** A round cone. */
    public Cone(double radius, double topRadius, double height) {
        this(radius, topRadius, height, 0);
    }

    /** A pointed cone. */
    public Cone(double radius, double height) {
        this(radius, 0, height);
    }

    @Override
    public Face face(int number) {
        return sides > 0 ? Prism.faceOf(number) : number == Placed.SIDE ? Face.SIDE : number == Placed.BOTTOM ? Face.BOTTOM : Face.TOP;
    }

    @Override
    public Bounds bounds() {
        if (sides > 0) {
            return Sided.worldBounds(Affine.IDENTITY, sides, radius, topRadius, height);
        }
        double widest = Math.max(radius, topRadius);
        return new Bounds(-widest, 0, -widest, widest, height, widest);
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        return sides > 0 ? Drawn.sided(sides, radius, topRadius, height) : Drawn.round(radius, topRadius, height, along, steps);
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return parts.add(part -> sides > 0 ? new Sided(part, toWorld, sides, radius, topRadius, height) : new Placed(part, toWorld, this));
    }

    /** The box around a body of two discs about the y axis and what is between them. */
    static Bounds roundBounds(Affine toWorld, double bottom, double top, double height) {
        Affine toTop = toWorld.after(Affine.translation(new Vec3(0, height, 0)));
        return Bounds.ofEllipsoid(toWorld, bottom, 0, bottom).union(Bounds.ofEllipsoid(toTop, top, 0, top));
    }

    /**
     * Met in its own space: the stretch between the caps and within the endless double cone x² + z² ≤ (r + k·y)².
     * Between the caps r + k·y is never negative, so the other nappe does not matter.
     */
    private static final class Placed extends LocalConvex {
        private static final int SIDE = 0;
        private static final int BOTTOM = 1;
        /** By more than so much the radius changes for each step upwards in a cone that is flat. */
        private static final double FLAT = 1e3;

        private final double radius;
        private final double topRadius;
        private final double slope;
        private final boolean isFlat;
        private final double height;

        Placed(int part, Affine toWorld, Cone shape) {
            super(part, toWorld, roundBounds(toWorld, shape.radius, shape.topRadius, shape.height));
            radius = shape.radius;
            topRadius = shape.topRadius;
            slope = (shape.topRadius - shape.radius) / shape.height;
            isFlat = Math.abs(slope) > FLAT;
            height = shape.height;
        }

        @Override
        protected boolean clip(Line line, Ray ray) {
            open(ray);
            if (!narrow(ray, line.oy, line.dy, 0, height, BOTTOM)) {
                return false;
            }
            // From the point of the line nearest to the cone: the squares of large numbers would lose a small cone far away.
            double dd = line.dx * line.dx + line.dz * line.dz;
            double near = -(line.ox * line.dx + (line.oy - height / 2) * line.dy + line.oz * line.dz) / (dd + line.dy * line.dy);
            if (isFlat) {
                // Beyond the caps the endless cone is so wide that nothing is left of this one.
                near = Math.max(ray.enter, Math.min(ray.leave, near));
            }
            double x = line.ox + near * line.dx;
            double z = line.oz + near * line.dz;
            double w = radius + slope * (line.oy + near * line.dy);
            double dw = slope * line.dy;
            double a = dd - dw * dw;
            double b = x * line.dx + z * line.dz - w * dw;
            double c = x * x + z * z - w * w;
            double discriminant = b * b - a * c;
            if (!(discriminant > 0)) {
                // No crossing: the line is inside all along if its form is negative, which it is exactly when a < 0.
                return a < 0;
            }
            // The root of larger size without cancellation, the other from the product of both.
            double q = -(b + Math.copySign(Math.sqrt(discriminant), b));
            double t0 = q / a;
            double t1 = c / q;
            double first = near + Math.min(t0, t1);
            double second = near + Math.max(t0, t1);
            return a > 0 ? narrow(ray, first, SIDE, second, SIDE) : narrowOutside(ray, first, second);
        }

        /** For a ray steeper than the side: inside before the first crossing and after the second, of which the caps leave one. */
        private static boolean narrowOutside(Ray ray, double first, double second) {
            return first - ray.enter > ray.leave - second
                    ? narrow(ray, Double.NEGATIVE_INFINITY, SIDE, first, SIDE)
                    : narrow(ray, second, SIDE, Double.POSITIVE_INFINITY, SIDE);
        }

        @Override
        protected void describe(int face, double x, double y, double z, Affine toLocal, Hit hit) {
            if (face == SIDE) {
                hit.normal(toLocal, x, -slope * (radius + slope * y), z);
            } else {
                hit.normal(toLocal, 0, face == BOTTOM ? -1 : 1, 0);
            }
        }

        @Override
        protected void map(int face, double x, double y, double z, Hit hit) {
            if (face == SIDE) {
                hit.mapAround(x, z, y / height);
            } else {
                hit.mapLid(x, z, face == BOTTOM ? radius : topRadius, face != BOTTOM);
            }
        }
    }
}
