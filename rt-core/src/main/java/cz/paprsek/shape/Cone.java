package cz.paprsek.shape;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;

/** A closed cone about the y axis: {@code radius} at y = 0, {@code topRadius} at y = height; pointed if that is 0. */
public record Cone(double radius, double topRadius, double height) implements Solid {
    public Cone {
        Require.notNegative("cone radius", radius);
        Require.notNegative("cone top-radius", topRadius);
        Require.that(radius > 0 || topRadius > 0, "cone radius and top-radius must not both be 0");
        Require.positive("cone height", height);
    }

    /** A pointed cone. */
    public Cone(double radius, double height) {
        this(radius, 0, height);
    }

    @Override
    public Bounds bounds() {
        double widest = Math.max(radius, topRadius);
        return new Bounds(-widest, 0, -widest, widest, height, widest);
    }
}
