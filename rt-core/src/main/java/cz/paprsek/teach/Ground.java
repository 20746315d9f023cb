package cz.paprsek.teach;

import cz.paprsek.math.Affine;
import cz.paprsek.teach.Primitive.Stretch;

/** The half-space y ≤ 0. */
final class Ground extends Primitive.Convex {
    private final Affine toOwn;

    Ground(int number, Paint paint, Affine toWorld) {
        super(number, paint);
        this.toOwn = toWorld.inverse();
    }

    @Override
    Stretch inside(Ray ray) {
        return Stretch.ALL.between(ray.start().through(toOwn).y(), ray.direction().along(toOwn).y(), Double.NEGATIVE_INFINITY, 0, -1);
    }

    @Override
    Vec normal(Vec point, int face) {
        return new Vec(0, 1, 0).normalFrom(toOwn);
    }
}
