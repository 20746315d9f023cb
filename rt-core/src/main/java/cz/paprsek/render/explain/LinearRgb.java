package cz.paprsek.render.explain;

import cz.paprsek.material.Rgb;

/** Light of three channels, linear: 1 is white, more is possible. */
public record LinearRgb(double red, double green, double blue) {
    public static final LinearRgb BLACK = new LinearRgb(0, 0, 0);

    public static final LinearRgb WHITE = new LinearRgb(1, 1, 1);

    /** The light that a colour stands for. */
    public static LinearRgb of(Rgb color) {
        return new LinearRgb(color.linearRed(), color.linearGreen(), color.linearBlue());
    }

    public LinearRgb plus(LinearRgb other) {
        return new LinearRgb(red + other.red, green + other.green, blue + other.blue);
    }

    public LinearRgb times(double factor) {
        return new LinearRgb(factor * red, factor * green, factor * blue);
    }

    /** Channel by channel. */
    public LinearRgb times(LinearRgb other) {
        return new LinearRgb(red * other.red, green * other.green, blue * other.blue);
    }

    /** Whether all channels are the same. */
    public boolean isGrey() {
        return red == green && green == blue;
    }

    /** The most that one of the channels is. */
    public double most() {
        return Math.max(red, Math.max(green, blue));
    }

    /** How far two lights are apart: the differences of the channels added up. */
    public double distance(LinearRgb other) {
        return Math.abs(red - other.red) + Math.abs(green - other.green) + Math.abs(blue - other.blue);
    }

    /** As a picture shows it: sRGB, clamped to 0–255. */
    public Rgb shown() {
        return Rgb.ofLinear(clamped(red), clamped(green), clamped(blue));
    }

    private static double clamped(double light) {
        // In this order a value that is not a number becomes 0.
        return light > 0 ? Math.min(light, 1) : 0;
    }
}
