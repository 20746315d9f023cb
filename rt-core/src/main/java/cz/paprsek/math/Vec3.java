package cz.paprsek.math;

import org.jspecify.annotations.Nullable;

/**
 * A point, a direction or three numbers of any kind, in a right-handed space with y up.
 * Every component is finite; the constructor refuses anything else.
 */
public record Vec3(double x, double y, double z) {
    public static final Vec3 ZERO = new Vec3(0, 0, 0);
    public static final Vec3 ONE = new Vec3(1, 1, 1);
    public static final Vec3 X = new Vec3(1, 0, 0);
    public static final Vec3 Y = new Vec3(0, 1, 0);
    public static final Vec3 Z = new Vec3(0, 0, 1);

    /** @throws IllegalArgumentException if a component is infinite or not a number */
    public Vec3 {
        Require.finite("x", x);
        Require.finite("y", y);
        Require.finite("z", z);
    }

    /** As that of any record, but at hand: what makes those of records takes long the first time, and every start needs this one. */
    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof Vec3 v && Double.compare(x, v.x) == 0 && Double.compare(y, v.y) == 0 && Double.compare(z, v.z) == 0;
    }

    @Override
    public int hashCode() {
        return 31 * (31 * Double.hashCode(x) + Double.hashCode(y)) + Double.hashCode(z);
    }

    public Vec3 plus(Vec3 v) {
        return new Vec3(x + v.x, y + v.y, z + v.z);
    }

    public Vec3 minus(Vec3 v) {
        return new Vec3(x - v.x, y - v.y, z - v.z);
    }

    public Vec3 times(double factor) {
        return new Vec3(x * factor, y * factor, z * factor);
    }

    public Vec3 negated() {
        return new Vec3(-x, -y, -z);
    }

    public double dot(Vec3 v) {
        return x * v.x + y * v.y + z * v.z;
    }

    /** The right-handed cross product: X × Y = Z. */
    public Vec3 cross(Vec3 v) {
        return new Vec3(y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x);
    }

    /** The Euclidean length; finite for every vector whose length can be represented. */
    public double length() {
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (largest == 0) {
            return 0;
        }
        double a = x / largest;
        double b = y / largest;
        double c = z / largest;
        return largest * Math.sqrt(a * a + b * b + c * c);
    }

    /**
     * The vector of length 1 in the same direction, also for components whose squares would overflow or vanish.
     *
     * @throws IllegalArgumentException if this vector is zero
     */
    public Vec3 normalized() {
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        Require.that(largest > 0, "a vector of length zero has no direction");
        double a = x / largest;
        double b = y / largest;
        double c = z / largest;
        double length = Math.sqrt(a * a + b * b + c * c);
        return new Vec3(a / length, b / length, c / length);
    }
}
