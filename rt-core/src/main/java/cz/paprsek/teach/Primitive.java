package cz.paprsek.teach;

import java.util.List;

/** A sphere, a block and so on, in the world. */
abstract class Primitive implements Thing {
    /** Of surfaces in one place, that with the lowest number is seen. */
    final int number;
    final Paint paint;

    Primitive(int number, Paint paint) {
        this.number = number;
        this.paint = paint;
    }

    /** The normal at a point of a face, of length 1, out of the solid. */
    abstract Vec normal(Vec point, int face);

    /** Where on a flat figure a point is, 0–1 to the right and upwards. */
    double[] place(Vec point) {
        return new double[2];
    }

    /** A solid that every line meets in one stretch at most. */
    abstract static class Convex extends Primitive {
        Convex(int number, Paint paint) {
            super(number, paint);
        }

        /** The stretch of the line that is inside. */
        abstract Stretch inside(Ray ray);

        @Override
        public List<Crossing> crossings(Ray ray) {
            Stretch stretch = ray.leaves(this) && !ray.inwards() ? Stretch.NONE : inside(ray);
            if (stretch.isEmpty()) {
                return List.of();
            }
            // Who starts on the surface, inwards, has entered there, and leaves at the far side.
            double enter = ray.leaves(this) ? Double.NEGATIVE_INFINITY : stretch.enter();
            double leave = ray.leaves(this) ? Math.max(stretch.leave(), 0) : stretch.leave();
            return List.of(new Crossing(enter, this, stretch.enterFace(), false), new Crossing(leave, this, stretch.leaveFace(), false));
        }
    }
}
