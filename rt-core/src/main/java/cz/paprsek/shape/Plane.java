package cz.paprsek.shape;

import cz.paprsek.math.Bounds;

/** The solid half-space y ≤ 0: ground without end, or a knife for CSG. */
public record Plane() implements Solid {
    @Override
    public Bounds bounds() {
        double inf = Double.POSITIVE_INFINITY;
        return new Bounds(-inf, -inf, -inf, inf, 0, inf);
    }
}
