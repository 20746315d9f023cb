package cz.paprsek.material;

import cz.paprsek.math.Require;

/**
 * A colour as people write it: sRGB-encoded, 0–255 per channel, decimals allowed.
 * Arithmetic is done on {@linkplain #linear(double) linear} values.
 */
public record Rgb(double red, double green, double blue) {
    public static final Rgb BLACK = new Rgb(0, 0, 0);
    public static final Rgb WHITE = new Rgb(255, 255, 255);

    /** @throws IllegalArgumentException if a channel is outside 0–255 */
    public Rgb {
        Require.within("red", red, 0, 255);
        Require.within("green", green, 0, 255);
        Require.within("blue", blue, 0, 255);
    }

    /** A grey of equal channels. */
    public static Rgb grey(double level) {
        return new Rgb(level, level, level);
    }

    /** The colour with the given linear channels, each 0–1. */
    public static Rgb ofLinear(double red, double green, double blue) {
        return new Rgb(encoded(red), encoded(green), encoded(blue));
    }

    public double linearRed() {
        return linear(red);
    }

    public double linearGreen() {
        return linear(green);
    }

    public double linearBlue() {
        return linear(blue);
    }

    /**
     * Linear light, 0–1, of an sRGB channel 0–255.
     *
     * @source IEC 61966-2-1:1999
     */
    public static double linear(double channel) {
        double v = channel / 255;
        return v <= 0.04045 ? v / 12.92 : StrictMath.pow((v + 0.055) / 1.055, 2.4);
    }

    /**
     * The sRGB channel 0–255 of linear light 0–1.
     *
     * @source IEC 61966-2-1:1999
     */
    public static double encoded(double light) {
        double v = light <= 0.0031308 ? light * 12.92 : 1.055 * StrictMath.pow(light, 1 / 2.4) - 0.055;
        return v * 255;
    }
}
