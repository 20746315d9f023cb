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
import cz.paprsek.shape.outline.Drawn;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Rounded;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** A rod with round ends: all that is not farther than the radius from the y axis between y = 0 and y = height. */
@Element("A cylinder about its y axis, from y = 0, with half a ball at either end.")
public record Capsule(
        @Attribute(value = Kind.POSITIVE, means = "Above 0", example = "0.4") double radius,
        @Attribute(value = Kind.NOT_NEGATIVE, means = "From the middle of one half ball to that of the other; 0 makes a sphere", example = "0.4") double height) implements Solid {
    public Capsule {
        Require.size("capsule radius", radius);
        Require.sizeOrZero("capsule height", height);
    }

    @Override
    public Bounds bounds() {
        return new Bounds(-radius, -radius, -radius, radius, height + radius, radius);
    }

    /** The silhouette of a ball, of which the halves lie apart, and the two rims. */
    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        Vec3 radii = new Vec3(radius, radius, radius);
        List<Vec3> ball = Drawn.ellipsoid(radii, along, steps).points();
        List<Vec3> apart = new ArrayList<>();
        for (int i = 0; i < ball.size(); i++) {
            Vec3 p = ball.get(i);
            Vec3 before = ball.get(i > 0 ? i - 1 : ball.size() - 2);
            if (before.y() > 0 != p.y() > 0) {
                Vec3 onRim = before.plus(p.minus(before).times(before.y() / (before.y() - p.y()))).normalized().times(radius);
                apart.add(lifted(onRim, before.y() > 0));
                apart.add(lifted(onRim, p.y() > 0));
            }
            apart.add(lifted(p, p.y() > 0));
        }
        Vec3 x = new Vec3(radius, 0, 0);
        Vec3 z = new Vec3(0, 0, radius);
        return List.of(new Curve(apart), Drawn.circle(Vec3.ZERO, x, z, steps), Drawn.circle(new Vec3(0, height, 0), x, z, steps));
    }

    private Vec3 lifted(Vec3 p, boolean isUpper) {
        return isUpper ? p.plus(new Vec3(0, height, 0)) : p;
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return parts.add(part -> new Placed(part, toWorld, this));
    }

    /** Mapped as a globe of which the halves lie apart: v is the way over the surface, from the lower end to the upper. */
    private static final class Placed extends Rounded {
        private final double radius;
        private final double height;

        Placed(int part, Affine toWorld, Capsule shape) {
            super(part, toWorld, new Vec3(0, shape.height / 2, 0), new Vec3(0, shape.height / 2, 0), shape.radius);
            radius = shape.radius;
            height = shape.height;
        }

        @Override
        protected void map(int face, double x, double y, double z, Hit hit) {
            double straight = Math.max(0, Math.min(height, y));
            double latitude = StrictMath.atan2(y - straight, Math.sqrt(x * x + z * z));
            hit.mapAround(x, z, (radius * (Math.PI / 2 + latitude) + straight) / (Math.PI * radius + height));
        }
    }
}
