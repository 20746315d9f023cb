package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.RECTANGLE_ONE_SIDED;
import static cz.paprsek.teach.mistake.Mistake.RECTANGLE_SIGN;

import cz.paprsek.math.Affine;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.List;

/** A rectangle or disc in the plane z = 0 of its own space: a line meets it at t = −o.z / d.z. */
final class Figure extends Primitive {
    private final Affine toOwn;
    private final Shape shape;
    private final Mistakes made;

    Figure(int number, Paint paint, Affine toWorld, Shape shape, Mistakes made) {
        super(number, paint);
        this.toOwn = toWorld.inverse();
        this.shape = shape;
        this.made = made;
    }

    @Override
    public List<Crossing> crossings(Ray ray) {
        Vec o = ray.start().through(toOwn);
        Vec d = ray.direction().along(toOwn);
        if (ray.leaves(this) || (made.has(RECTANGLE_ONE_SIDED) ? d.z() >= 0 : d.z() == 0)) {
            return List.of();
        }
        double t = (made.has(RECTANGLE_SIGN) ? o.z() : -o.z()) / d.z();
        return holds(o.x() + t * d.x(), o.y() + t * d.y()) ? List.of(new Crossing(t, this, 0, false)) : List.of();
    }

    private boolean holds(double x, double y) {
        if (shape instanceof Disc disc) {
            return x * x + y * y <= disc.radius() * disc.radius();
        }
        Rectangle r = (Rectangle) shape;
        return x >= r.minX() && x <= r.maxX() && y >= r.minY() && y <= r.maxY();
    }

    @Override
    Vec normal(Vec point, int face) {
        return new Vec(0, 0, 1).normalFrom(toOwn);
    }

    @Override
    double[] place(Vec point) {
        Vec own = point.through(toOwn);
        if (shape instanceof Disc disc) {
            return new double[] {(own.x() / disc.radius() + 1) / 2, (own.y() / disc.radius() + 1) / 2};
        }
        Rectangle r = (Rectangle) shape;
        return new double[] {(own.x() - r.minX()) / (r.maxX() - r.minX()), (own.y() - r.minY()) / (r.maxY() - r.minY())};
    }
}
