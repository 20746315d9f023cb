package cz.paprsek.shape;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Numbers;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;

/** A box with faces perpendicular to the axes, from its minimum to its maximum corner. */
public record Block(Vec3 min, Vec3 max) implements Solid {
    public Block {
        Require.that(min.x() < max.x() && min.y() < max.y() && min.z() < max.z(),
                "block min must be below max along every axis, but min is " + Numbers.text(min) + " and max is "
                        + Numbers.text(max));
    }

    @Override
    public Bounds bounds() {
        return Bounds.of(min, max);
    }
}
