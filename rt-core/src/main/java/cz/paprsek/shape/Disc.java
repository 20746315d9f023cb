package cz.paprsek.shape;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;

/** A disc in the plane z = 0 about the origin, facing +z, seen from both sides. It has no inside. */
public record Disc(double radius) implements Shape {
    public Disc {
        Require.positive("disc radius", radius);
    }

    @Override
    public Bounds bounds() {
        return new Bounds(-radius, -radius, 0, radius, radius, 0);
    }
}
