package cz.paprsek.fx.view.projection;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import java.util.Locale;

/**
 * From where a projection looks. Its plane has u to the right and v up, as the viewer sees it; u and v are axes of the world or, where the
 * viewer sees those run to the left or down, their opposites.
 */
public enum Axes {
    /** From the front, against z: x to the right, y up. */
    FRONT(Axis.X, 1, Axis.Y, 1, Axis.Z),
    /** From above, against y: x to the right, z down. */
    TOP(Axis.X, 1, Axis.Z, -1, Axis.Y),
    /** From the right, against x: z to the left, y up. */
    RIGHT(Axis.Z, -1, Axis.Y, 1, Axis.X);

    /** An axis of the world. */
    enum Axis {
        X, Y, Z;

        double of(Vec3 p) {
            return switch (this) {
                case X -> p.x();
                case Y -> p.y();
                case Z -> p.z();
            };
        }

        String letter() {
            return name().toLowerCase(Locale.ROOT);
        }

        Vec3 times(double length) {
            return switch (this) {
                case X -> new Vec3(length, 0, 0);
                case Y -> new Vec3(0, length, 0);
                case Z -> new Vec3(0, 0, length);
            };
        }
    }

    private final Axis right;
    private final int rightSign;
    private final Axis up;
    private final int upSign;
    private final Axis towards;

    Axes(Axis right, int rightSign, Axis up, int upSign, Axis towards) {
        this.right = right;
        this.rightSign = rightSign;
        this.up = up;
        this.upSign = upSign;
        this.towards = towards;
    }

    /** The world's axis that lies along u. */
    Axis right() {
        return right;
    }

    /** The world's axis that lies along v. */
    Axis up() {
        return up;
    }

    double u(Vec3 p) {
        return rightSign * right.of(p);
    }

    double v(Vec3 p) {
        return upSign * up.of(p);
    }

    /** The vector in the plane of the projection. */
    Vec3 vector(double u, double v) {
        return right.times(rightSign * u).plus(up.times(upSign * v));
    }

    /** The part of a vector that points at the viewer or away. */
    Vec3 inDepth(Vec3 v) {
        return towards.times(towards.of(v));
    }

    /** A vector with one component along each of the plane's axes, whichever way these run: factors, not lengths. */
    Vec3 factors(double alongU, double alongV) {
        return right.times(alongU).plus(up.times(alongV)).plus(towards.times(1));
    }

    /** Where the viewer looks. */
    Vec3 along() {
        return towards.times(-1);
    }

    /** Degrees about x, y and z that turn the picture counter-clockwise by an angle. */
    Vec3 rotation(double degrees) {
        return towards.times(degrees);
    }

    /** The coordinate along u as the world counts it. */
    double worldU(double u) {
        return rightSign * u;
    }

    /** The coordinate along v as the world counts it. */
    double worldV(double v) {
        return upSign * v;
    }

    /** u of a mapped point, without making the point. */
    double u(Affine map, Vec3 p) {
        return rightSign * coordinate(right, map, p);
    }

    /** v of a mapped point, without making the point. */
    double v(Affine map, Vec3 p) {
        return upSign * coordinate(up, map, p);
    }

    private static double coordinate(Axis axis, Affine map, Vec3 p) {
        return switch (axis) {
            case X -> map.pointX(p.x(), p.y(), p.z());
            case Y -> map.pointY(p.x(), p.y(), p.z());
            case Z -> map.pointZ(p.x(), p.y(), p.z());
        };
    }
}
