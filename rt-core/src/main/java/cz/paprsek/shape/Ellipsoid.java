package cz.paprsek.shape;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;

/** An ellipsoid about the origin with semi-axes along x, y and z. */
public record Ellipsoid(Vec3 semiAxes) implements Solid {
    public Ellipsoid {
        Require.positive("ellipsoid semi-axis x", semiAxes.x());
        Require.positive("ellipsoid semi-axis y", semiAxes.y());
        Require.positive("ellipsoid semi-axis z", semiAxes.z());
    }

    @Override
    public Bounds bounds() {
        return Bounds.around(Vec3.ZERO, semiAxes);
    }
}
