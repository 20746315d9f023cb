package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.ELLIPSOID_AS_DIRECTION;
import static cz.paprsek.teach.mistake.Mistake.NORMAL_BY_MATRIX;

import cz.paprsek.math.Affine;
import cz.paprsek.teach.Primitive.Stretch;
import cz.paprsek.teach.mistake.Mistakes;

/** An ellipsoid: the ball of radius 1 in a space of its own, where the line's direction has any length. */
final class Oval extends Primitive.Convex {
    private final Affine toWorld;
    private final Affine toOwn;
    private final Mistakes made;

    Oval(int number, Paint paint, Affine fromUnit, Mistakes made) {
        super(number, paint);
        this.toWorld = fromUnit;
        this.toOwn = fromUnit.inverse();
        this.made = made;
    }

    @Override
    Stretch inside(Ray ray) {
        Vec o = ray.start().through(toOwn);
        Vec d = ray.direction().along(toOwn);
        double dd = d.dot(d);
        double middle = -o.dot(d) / dd;
        Vec p = o.plus(d.times(middle));
        double half = (made.has(ELLIPSOID_AS_DIRECTION) ? 0 : 1) - p.dot(p);
        if (!(half > 0)) {
            return Stretch.NONE;
        }
        double s = Math.sqrt(half / dd);
        return new Stretch(middle - s, 0, middle + s, 0);
    }

    @Override
    Vec normal(Vec point, int face) {
        Vec own = point.through(toOwn);
        return made.has(NORMAL_BY_MATRIX) ? own.along(toWorld).unit() : own.normalFrom(toOwn);
    }
}
