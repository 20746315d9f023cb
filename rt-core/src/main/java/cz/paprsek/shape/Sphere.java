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
import cz.paprsek.shape.placed.Ball;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;
import java.util.List;

/** A ball about the origin. */
@Element("A ball about its origin.")
public record Sphere(@Attribute(value = Kind.POSITIVE, means = "Above 0") double radius) implements Solid {
    public Sphere {
        Require.size("sphere radius", radius);
    }

    @Override
    public Bounds bounds() {
        return Bounds.around(Vec3.ZERO, new Vec3(radius, radius, radius));
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        return List.of(Drawn.ellipsoid(new Vec3(radius, radius, radius), along, steps));
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return place(toWorld, radius, radius, radius, parts);
    }

    /** A ball stays a ball as long as no direction is stretched more than another; else it is met as the unit ball in its own space. */
    static Volume place(Affine toWorld, double a, double b, double c, Parts parts) {
        Affine fromUnit = toWorld.after(Affine.scaling(new Vec3(a, b, c)));
        double radius = fromUnit.uniformScale();
        return radius > 0
                ? parts.add(part -> new Ball(part, toWorld, radius))
                : parts.add(part -> new Ellipsoid.Placed(part, fromUnit));
    }
}
