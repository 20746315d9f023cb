package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.outline.Drawn;
import cz.paprsek.shape.placed.Flat;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Surface;
import java.util.List;
import java.util.Objects;

/** A disc in the plane z = 0 about the origin, facing +z, seen from both sides. It has no inside. */
@Element("A disc in its plane z = 0, facing +z, seen from both sides. It has no inside.")
public record Disc(@Attribute(value = Kind.POSITIVE, means = "Above 0") double radius) implements Shape {
    public Disc {
        Require.size("disc radius", radius);
    }

    @Override
    public Bounds bounds() {
        return new Bounds(-radius, -radius, 0, radius, radius, 0);
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        return List.of(Drawn.circle(Vec3.ZERO, new Vec3(radius, 0, 0), new Vec3(0, radius, 0), steps));
    }

    @Override
    public Surface place(Affine toWorld, Parts parts) {
        return parts.add(part -> new Placed(part, toWorld, radius));
    }

    /** Met in its own space; u and v run over the square around it. */
    private static final class Placed extends Flat {
        private final double radius;

        Placed(int part, Affine toWorld, double radius) {
            super(part, toWorld, Bounds.ofEllipsoid(toWorld, radius, radius, 0));
            this.radius = radius;
        }

        @Override
        protected boolean holds(double x, double y) {
            return x * x + y * y <= radius * radius;
        }

        @Override
        protected double u(double x) {
            return (x / radius + 1) / 2;
        }

        @Override
        protected double v(double y) {
            return (y / radius + 1) / 2;
        }
    }
}
