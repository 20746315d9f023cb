package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.NORMAL_NOT_UNIT;

import cz.paprsek.teach.Primitive.Stretch;
import cz.paprsek.teach.mistake.Mistakes;

/** A sphere. With b = (S − o)·d, a line d through o crosses it at b ± √(r² − |S − o − b·d|²). */
final class Ball extends Primitive.Convex {
    private final Vec center;
    private final double radius;
    private final Mistakes made;

    Ball(int number, Paint paint, Vec center, double radius, Mistakes made) {
        super(number, paint);
        this.center = center;
        this.radius = radius;
        this.made = made;
    }

    @Override
    Stretch inside(Ray ray) {
        double b = center.minus(ray.start()).dot(ray.direction());
        Vec off = center.minus(ray.start()).minus(ray.direction().times(b));
        double half = radius * radius - off.dot(off);
        if (!(half > 0)) {
            return Stretch.NONE;
        }
        double s = Math.sqrt(half);
        return new Stretch(b - s, 0, b + s, 0);
    }

    @Override
    Vec normal(Vec point, int face) {
        return made.has(NORMAL_NOT_UNIT) ? point.minus(center).times(2) : point.minus(center).unit();
    }
}
