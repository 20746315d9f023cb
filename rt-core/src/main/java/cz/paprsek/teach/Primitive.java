package cz.paprsek.teach;

import cz.paprsek.teach.Body.Thing;
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

    /** A stretch of a line, and the faces at its ends. */
    record Stretch(double enter, int enterFace, double leave, int leaveFace) {
        static final Stretch NONE = new Stretch(Double.POSITIVE_INFINITY, 0, Double.NEGATIVE_INFINITY, 0);
        static final Stretch ALL = new Stretch(Double.NEGATIVE_INFINITY, 0, Double.POSITIVE_INFINITY, 0);

        boolean isEmpty() {
            return !(enter < leave);
        }

        /** What it has in common with another one. */
        Stretch within(double from, int fromFace, double to, int toFace) {
            return new Stretch(from > enter ? from : enter, from > enter ? fromFace : enterFace, to < leave ? to : leave, to < leave ? toFace : leaveFace);
        }

        /** The part where low ≤ o + t·d ≤ high along one axis; the face at high has the number after that at low. */
        Stretch between(double o, double d, double low, double high, int lowFace) {
            double r = 1 / d;
            if (Double.isInfinite(r)) {
                return o >= low && o <= high ? this : NONE;
            }
            double atLow = (low - o) * r;
            double atHigh = (high - o) * r;
            return d > 0 ? within(atLow, lowFace, atHigh, lowFace + 1) : within(atHigh, lowFace + 1, atLow, lowFace);
        }
    }
}
