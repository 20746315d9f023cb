package cz.paprsek.shape;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;

/**
 * A ring about the y axis.
 *
 * @param majorRadius from the axis to the middle of the tube
 * @param minorRadius of the tube; may exceed the major radius, which closes the hole
 */
public record Torus(double majorRadius, double minorRadius) implements Solid {
    public Torus {
        Require.positive("torus major-radius", majorRadius);
        Require.positive("torus minor-radius", minorRadius);
    }

    @Override
    public Bounds bounds() {
        double outer = majorRadius + minorRadius;
        return new Bounds(-outer, -minorRadius, -outer, outer, minorRadius, outer);
    }
}
