package cz.paprsek.render.show;

import cz.paprsek.material.Rgb;

/** A colour for every object, by its number: neighbours in the list are far apart on the wheel of colours. */
public final class ObjectColors {
    /** The golden section of the wheel: however many steps of it, no two come close. */
    private static final double STEP = 0.618033988749895;

    private ObjectColors() {}

    public static Rgb of(int object) {
        double hue = (object + 1) * STEP % 1;
        double value = 255 - 75.0 * (object % 3) / 2;
        return new Rgb(channel(hue + 1.0 / 3, value), channel(hue, value), channel(hue - 1.0 / 3, value));
    }

    /** One channel of a colour of saturation 0.7: a trapezoid around the wheel. */
    private static double channel(double hue, double value) {
        double x = 6 * (hue - Math.floor(hue));
        double share = Math.min(1, Math.max(0, 2 - Math.abs(x - 2)));
        return value * (0.3 + 0.7 * share);
    }
}
