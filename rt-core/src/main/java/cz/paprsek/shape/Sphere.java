package cz.paprsek.shape;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;

/** A ball about the origin. */
public record Sphere(double radius) implements Solid {
    public Sphere {
        Require.positive("sphere radius", radius);
    }

    @Override
    public Bounds bounds() {
        return Bounds.around(Vec3.ZERO, new Vec3(radius, radius, radius));
    }
}
