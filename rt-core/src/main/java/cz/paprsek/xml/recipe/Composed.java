package cz.paprsek.xml.recipe;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Placement;
import java.util.Optional;

/** Placements one within another, as one. */
final class Composed {
    /** Nearer than this, in radians, to where x and z turn about one axis, all is said by z. */
    private static final double GIMBAL = 1e-12;

    private Composed() {}

    /**
     * The placement of what is placed within something that is placed itself. Sums where one of both only moves, or both turn about the same axis: as
     * people write it by hand, and to the last digit what they get then.
     *
     * @return empty if there is none: something turned within what is drawn out along an axis becomes skew
     */
    static Optional<Placement> of(Placement outer, Placement inner) {
        if (outer.equals(Placement.NONE)) {
            return Optional.of(inner);
        }
        if (inner.equals(Placement.NONE)) {
            return Optional.of(outer);
        }
        boolean isTurned = !inner.rotation().equals(Vec3.ZERO);
        if (isTurned && !isEven(outer.scale())) {
            return Optional.empty();
        }
        boolean isOnlyMoved = outer.rotation().equals(Vec3.ZERO) && outer.scale().equals(Vec3.ONE);
        Vec3 position = isOnlyMoved ? outer.position().plus(inner.position()) : outer.toParent().point(inner.position());
        return Optional.of(new Placement(position, rotation(outer, inner), product(outer.scale(), inner.scale())));
    }

    /** Each copy of something that is placed relative to the one before. */
    static final class Steps {
        private final Placement step;
        /** Whether moving and turning do not get in each other's way: along the same axis, or one of both alone. */
        private final boolean isPlain;
        private Placement latest = Placement.NONE;
        private int number;

        Steps(Placement step) {
            this.step = step;
            Vec3 r = step.rotation();
            Vec3 p = step.position();
            boolean isOneAxis = (r.x() == 0 ? 0 : 1) + (r.y() == 0 ? 0 : 1) + (r.z() == 0 ? 0 : 1) <= 1;
            boolean isAlong = (r.x() == 0 || (p.y() == 0 && p.z() == 0)) && (r.y() == 0 || (p.x() == 0 && p.z() == 0)) && (r.z() == 0 || (p.x() == 0 && p.y() == 0));
            isPlain = step.scale().equals(Vec3.ONE) && isOneAxis && isAlong;
        }

        /** Where the next copy stands; the first where it would without being repeated. */
        Optional<Placement> next() {
            if (number > 0) {
                Optional<Placement> next = isPlain ? Optional.of(new Placement(step.position().times(number), step.rotation().times(number), Vec3.ONE))
                        : of(latest, step);
                if (next.isEmpty()) {
                    return next;
                }
                latest = next.get();
            }
            number++;
            return Optional.of(latest);
        }
    }

    private static boolean isEven(Vec3 scale) {
        return scale.x() == scale.y() && scale.y() == scale.z();
    }

    private static Vec3 product(Vec3 a, Vec3 b) {
        return new Vec3(a.x() * b.x(), a.y() * b.y(), a.z() * b.z());
    }

    private static Vec3 rotation(Placement outer, Placement inner) {
        Vec3 a = outer.rotation();
        Vec3 b = inner.rotation();
        if (a.equals(Vec3.ZERO) || b.equals(Vec3.ZERO) || isSameAxis(a, b)) {
            return a.plus(b);
        }
        return angles(Affine.rotation(a).after(Affine.rotation(b)));
    }

    private static boolean isSameAxis(Vec3 a, Vec3 b) {
        return (a.x() == 0 && a.y() == 0 && b.x() == 0 && b.y() == 0) || (a.x() == 0 && a.z() == 0 && b.x() == 0 && b.z() == 0)
                || (a.y() == 0 && a.z() == 0 && b.y() == 0 && b.z() == 0);
    }

    /** The angles in degrees about x, then y, then z, of a rotation: z from what is left of it without x, so that both agree however near they are to one axis. */
    private static Vec3 angles(Affine r) {
        double across = Math.sqrt(r.zy() * r.zy() + r.zz() * r.zz());
        double x = across > GIMBAL ? StrictMath.atan2(r.zy(), r.zz()) : 0;
        double sine = StrictMath.sin(x);
        double cosine = StrictMath.cos(x);
        double y = StrictMath.atan2(-r.zx(), across);
        double z = StrictMath.atan2(r.xz() * sine - r.xy() * cosine, r.yy() * cosine - r.yz() * sine);
        return new Vec3(StrictMath.toDegrees(x), StrictMath.toDegrees(y), StrictMath.toDegrees(z));
    }
}
