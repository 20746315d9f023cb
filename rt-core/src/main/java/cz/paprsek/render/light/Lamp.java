package cz.paprsek.render.light;

import cz.paprsek.material.Rgb;
import cz.paprsek.ray.Hit;
import cz.paprsek.scene.Light;
import cz.paprsek.tree.Bundle;

/** A light ready for shading: one class for each kind. Immutable. */
public abstract class Lamp {
    private final double red;
    private final double green;
    private final double blue;

    Lamp(Rgb color, double intensity) {
        red = color.linearRed() * intensity;
        green = color.linearGreen() * intensity;
        blue = color.linearBlue() * intensity;
    }

    public static Lamp of(Light light) {
        return new PointLamp(light);
    }

    /** The light that arrives where nothing stands in the way, linear colour times intensity. */
    public final double red() {
        return red;
    }

    public final double green() {
        return green;
    }

    public final double blue() {
        return blue;
    }

    /** How many shadow rays a point sends; if it is 1, always the same one, for which nothing random is asked. */
    public abstract int samples();

    /**
     * Chooses a point of the light, and tells where it is.
     *
     * @param from the point it is looked for from
     * @param u which point, 0–1; without meaning for a light of no size
     * @param v likewise
     */
    public abstract void sample(Hit from, double u, double v, Arrival out);

    /** Starts a bundle of the lines from the light to many hits; false if they do not start in one place, and cannot be bundled. */
    public abstract boolean start(Bundle bundle);

    /**
     * Adds the line from the light to a hit to a bundle.
     *
     * @return at least the length of the line, at most √3 times that
     */
    public abstract double add(Hit hit, Bundle bundle);
}
