package cz.paprsek.shape;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;

/** The solid half-space y ≤ 0: ground without end, or a knife for CSG. */
public record Plane() implements Solid {
    @Override
    public Bounds bounds() {
        double inf = Double.POSITIVE_INFINITY;
        return new Bounds(-inf, -inf, -inf, inf, 0, inf);
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return parts.add(part -> new Placed(part, toWorld));
    }

    private static final class Placed extends LocalConvex {
        Placed(int part, Affine toWorld) {
            super(part, toWorld, Bounds.ALL);
        }

        @Override
        boolean clip(Line line, Ray ray) {
            open(ray);
            return narrow(ray, line.oy, line.dy, Double.NEGATIVE_INFINITY, 0, -1);
        }

        @Override
        void describe(int face, double x, double y, double z, Affine toLocal, Hit hit) {
            hit.normal(toLocal, 0, 1, 0);
        }
    }
}
