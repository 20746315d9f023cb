package cz.paprsek.teach;

import cz.paprsek.teach.Bodies.Met;
import org.jspecify.annotations.Nullable;

/**
 * A ray: the points start + t · direction.
 *
 * @param direction of length 1
 * @param size the numbers that led to the start, coordinates and distance travelled, added up: what its rounding errors are relative to
 * @param near a hit counts if its t is above this
 * @param from where it starts; null at the eye
 * @param inwards whether it starts into the inside of the primitive there
 * @param beyond whether it goes on beyond the surface there, rather than back to the side from which that was seen
 */
record Ray(Vec start, Vec direction, double size, double near, @Nullable Met from, boolean inwards, boolean beyond) {
    /** Surfaces nearer to one another than this, relative to the numbers they come from, lie in one place. */
    static final double TOUCH = 1e-11;

    static Ray fromEye(Vec start, Vec direction) {
        return new Ray(start, direction, start.size(), 0, null, false, false);
    }

    Vec at(double t) {
        return start.plus(direction.times(t));
    }

    /** Whether it starts from the surface of a primitive, which it does not meet there again. */
    boolean leaves(Primitive primitive) {
        return from != null && from.crossing().of().equals(primitive);
    }

    /** What is less far than this touches the surface it starts from. */
    double contact() {
        return from == null ? 0 : TOUCH * size;
    }

    /** How far from a hit at t others lie in one place with it. */
    double touch(double t) {
        return TOUCH * (size + Math.abs(t));
    }
}
