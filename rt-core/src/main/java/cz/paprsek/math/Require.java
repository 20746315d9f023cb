package cz.paprsek.math;

/** Checks of arguments, each with one sentence that says what was expected and what was found. */
public final class Require {
    /**
     * The largest coordinate and size, in scene units. Far beyond any scene there is (the universe has 1e61 Planck lengths), and far enough
     * from the largest double for every volume, area and fourth power that is worked out from them.
     */
    public static final double LARGEST = 1e45;
    /** The smallest size, in scene units; not of coordinates, which may be as near to 0 as they like. */
    public static final double SMALLEST = 1e-45;

    private Require() {}

    /** @throws IllegalArgumentException unless the value is finite */
    public static double finite(String what, double value) {
        return check(Double.isFinite(value), what, "a finite number", value);
    }

    /** @throws IllegalArgumentException unless the value is finite and above 0 */
    public static double positive(String what, double value) {
        return check(Double.isFinite(value) && value > 0, what, "a finite number above 0", value);
    }

    /** @throws IllegalArgumentException unless the value is finite and 0 or above */
    public static double notNegative(String what, double value) {
        return check(Double.isFinite(value) && value >= 0, what, "a finite number, 0 or above", value);
    }

    /** @throws IllegalArgumentException unless the value is a size that shapes can have: finite, from {@link #SMALLEST} to {@link #LARGEST} */
    public static double size(String what, double value) {
        return within(what, positive(what, value), SMALLEST, LARGEST);
    }

    /** @throws IllegalArgumentException unless the value is 0 or a size */
    public static double sizeOrZero(String what, double value) {
        return notNegative(what, value) == 0 ? value : size(what, value);
    }

    /** @throws IllegalArgumentException unless all three are sizes */
    public static Vec3 sizes(String what, Vec3 value) {
        size(what + " x", value.x());
        size(what + " y", value.y());
        size(what + " z", value.z());
        return value;
    }

    /** @throws IllegalArgumentException unless all three are factors: other than 0, and sizes but for their sign */
    public static Vec3 scale(Vec3 value) {
        if (value.x() == 0 || value.y() == 0 || value.z() == 0) {
            throw new IllegalArgumentException("scale must not be 0 along any axis, but is " + plain(value.x()) + " " + plain(value.y()) + " " + plain(value.z()));
        }
        size("scale along x", Math.abs(value.x()));
        size("scale along y", Math.abs(value.y()));
        size("scale along z", Math.abs(value.z()));
        return value;
    }

    /** @throws IllegalArgumentException unless the value lies within ±{@link #LARGEST} */
    public static double coordinate(String what, double value) {
        return within(what, finite(what, value), -LARGEST, LARGEST);
    }

    /** @throws IllegalArgumentException unless every coordinate lies within ±{@link #LARGEST} */
    public static Vec3 place(String what, Vec3 point) {
        if (!isCoordinate(point.x()) || !isCoordinate(point.y()) || !isCoordinate(point.z())) {
            coordinate(what + " x", point.x());
            coordinate(what + " y", point.y());
            coordinate(what + " z", point.z());
        }
        return point;
    }

    private static boolean isCoordinate(double value) {
        return Math.abs(value) <= LARGEST;
    }

    /** @throws IllegalArgumentException unless low ≤ value ≤ high */
    public static double within(String what, double value, double low, double high) {
        // Not NaN either. The sentence is put together only when it is needed: this runs for every number of a million objects.
        if (!(value >= low && value <= high)) {
            throw refused(what, "a number from " + plain(low) + " to " + plain(high), plain(value));
        }
        return value;
    }

    /** @throws IllegalArgumentException unless low ≤ value ≤ high */
    public static int within(String what, int value, int low, int high) {
        if (value < low || value > high) {
            throw refused(what, "a whole number from " + low + " to " + high, Integer.toString(value));
        }
        return value;
    }

    /** @throws IllegalArgumentException with the given sentence unless the condition holds */
    public static void that(boolean condition, String sentence) {
        if (!condition) {
            throw new IllegalArgumentException(sentence);
        }
    }

    private static double check(boolean condition, String what, String expected, double found) {
        if (!condition) {
            throw refused(what, expected, plain(found));
        }
        return found;
    }

    private static IllegalArgumentException refused(String what, String expected, String found) {
        return new IllegalArgumentException(what + " must be " + expected + ", but is " + found);
    }

    /** A number as a reader would write it: 180 rather than 180.0. */
    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9 ? Long.toString((long) value) : Double.toString(value);
    }
}
