package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.NORMAL_BY_MATRIX;

import cz.paprsek.math.Affine;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.teach.Primitive.Stretch;
import cz.paprsek.teach.mistake.Mistakes;

/** A closed cylinder about the y axis of its own space: what lies between its lids and within x² + z² = r². */
final class Drum extends Primitive.Convex {
    private static final int SIDE = 0;
    private static final int BOTTOM = 1;

    private final Affine toWorld;
    private final Affine toOwn;
    private final double radius;
    private final double height;
    private final Mistakes made;

    Drum(int number, Paint paint, Affine toWorld, Cylinder shape, Mistakes made) {
        super(number, paint);
        this.toWorld = toWorld;
        this.toOwn = toWorld.inverse();
        this.radius = shape.radius();
        this.height = shape.height();
        this.made = made;
    }

    @Override
    Stretch inside(Ray ray) {
        Vec o = ray.start().through(toOwn);
        Vec d = ray.direction().along(toOwn);
        Stretch between = Stretch.ALL.between(o.y(), d.y(), 0, height, BOTTOM);
        double dd = d.x() * d.x() + d.z() * d.z();
        if (dd == 0) {
            return o.x() * o.x() + o.z() * o.z() < radius * radius ? between : Stretch.NONE;
        }
        double middle = -(o.x() * d.x() + o.z() * d.z()) / dd;
        double px = o.x() + middle * d.x();
        double pz = o.z() + middle * d.z();
        double half = radius * radius - (px * px + pz * pz);
        if (!(half > 0)) {
            return Stretch.NONE;
        }
        double s = Math.sqrt(half / dd);
        return between.within(middle - s, SIDE, middle + s, SIDE);
    }

    @Override
    Vec normal(Vec point, int face) {
        Vec own = point.through(toOwn);
        Vec normal = face == SIDE ? new Vec(own.x(), 0, own.z()) : new Vec(0, face == BOTTOM ? -1 : 1, 0);
        return made.has(NORMAL_BY_MATRIX) ? normal.along(toWorld).unit() : normal.normalFrom(toOwn);
    }
}
