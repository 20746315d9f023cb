package cz.paprsek.shape;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;

/** A closed cylinder about the y axis, from y = 0 to y = height. */
public record Cylinder(double radius, double height) implements Solid {
    public Cylinder {
        Require.positive("cylinder radius", radius);
        Require.positive("cylinder height", height);
    }

    @Override
    public Bounds bounds() {
        return new Bounds(-radius, 0, -radius, radius, height, radius);
    }
}
