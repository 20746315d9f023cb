package cz.paprsek.math;

/** Sine, cosine and tangent of degrees, the same on every machine and exact at multiples of 90. */
public final class Angles {
    private Angles() {}

    /** Sine of an angle in degrees; exactly 0, 1 or −1 at multiples of 90, so that a quarter turn moves faces to where they belong. */
    public static double sin(double degrees) {
        double turn = degrees % 360;
        if (turn % 90 != 0) {
            return StrictMath.sin(StrictMath.toRadians(turn));
        }
        return switch (Math.floorMod((int) turn, 360)) {
            case 90 -> 1;
            case 270 -> -1;
            default -> 0;
        };
    }

    /** Cosine of an angle in degrees; exactly 0, 1 or −1 at multiples of 90. */
    public static double cos(double degrees) {
        double turn = degrees % 360;
        if (turn % 90 != 0) {
            return StrictMath.cos(StrictMath.toRadians(turn));
        }
        return switch (Math.floorMod((int) turn, 360)) {
            case 0 -> 1;
            case 180 -> -1;
            default -> 0;
        };
    }

    /** Tangent of an angle in degrees, by {@link StrictMath}. */
    public static double tan(double degrees) {
        return StrictMath.tan(StrictMath.toRadians(degrees));
    }
}
