package cz.paprsek.scene.motion;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;

/** A rotation as a quaternion of length 1, w + xi + yj + zk. */
public record Quaternion(double w, double x, double y, double z) {
    /** Rotations nearer to each other than this cosine of half the angle are mixed evenly: the sine that would be divided by is lost in rounding. */
    private static final double NEAR = 1 - 1e-12;
    /** As near to looking straight up or down as this, one of two angles about the same line is enough. */
    private static final double UPRIGHT = 1 - 1e-12;

    /** Of angles in degrees about x, then y, then z. */
    public static Quaternion ofDegrees(Vec3 degrees) {
        return about(2, degrees.z()).times(about(1, degrees.y())).times(about(0, degrees.x()));
    }

    private static Quaternion about(int axis, double degrees) {
        double sin = Angles.sin(degrees / 2);
        return new Quaternion(Angles.cos(degrees / 2), axis == 0 ? sin : 0, axis == 1 ? sin : 0, axis == 2 ? sin : 0);
    }

    private Quaternion times(Quaternion b) {
        return new Quaternion(w * b.w - x * b.x - y * b.y - z * b.z, w * b.x + x * b.w + y * b.z - z * b.y,
                w * b.y - x * b.z + y * b.w + z * b.x, w * b.z + x * b.y - y * b.x + z * b.w);
    }

    /**
     * Part of the shortest turn to another.
     *
     * @param share 0 for this, 1 for the other
     * @source Shoemake, Animating Rotation with Quaternion Curves, SIGGRAPH 1985
     */
    public Quaternion towards(Quaternion other, double share) {
        double cos = w * other.w + x * other.x + y * other.y + z * other.z;
        // Of the two that stand for the other rotation, the nearer.
        double sign = cos < 0 ? -1 : 1;
        double near = Math.abs(cos);
        double own = 1 - share;
        double others = share;
        if (near < NEAR) {
            double angle = StrictMath.acos(near);
            own = StrictMath.sin(own * angle) / StrictMath.sin(angle);
            others = StrictMath.sin(share * angle) / StrictMath.sin(angle);
        }
        double b = sign * others;
        return new Quaternion(own * w + b * other.w, own * x + b * other.x, own * y + b * other.y, own * z + b * other.z);
    }

    /** The angles in degrees about x, then y, then z. */
    public Vec3 degrees() {
        double sin = 2 * (w * y - z * x);
        boolean isUpright = Math.abs(sin) > UPRIGHT;
        double about = isUpright ? 0 : StrictMath.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y));
        double last = isUpright ? StrictMath.atan2(2 * (w * z - x * y), 1 - 2 * (x * x + z * z)) : StrictMath.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
        return new Vec3(StrictMath.toDegrees(about), StrictMath.toDegrees(StrictMath.asin(Math.max(-1, Math.min(1, sin)))), StrictMath.toDegrees(last));
    }
}
