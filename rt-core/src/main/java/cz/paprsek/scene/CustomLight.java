package cz.paprsek.scene;

import cz.paprsek.material.Rgb;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.text.MadeInCode;

/**
 * A light that is made in code rather than read from a file. Must be immutable; any number of workers ask it at once. Scene files and POV-Ray
 * cannot hold it.
 */
public non-sealed interface CustomLight extends Light {

    /** The word for its kind in lists, explanations and messages: the name of its class unless it says otherwise. */
    @Override
    default String kind() {
        return MadeInCode.kind(this);
    }

    /** How many shadow rays a point sends, 1 to {@value PlacedLight#MOST_SAMPLES}; if it is 1, always the same one, for which nothing random is asked. */
    default int samples() {
        return 1;
    }

    /**
     * Chooses a point of the light; the mean of what arrives from all that are chosen is its light.
     *
     * @param from the point that is lit, world space
     * @param u which point, 0–1, evenly strewn; ½ if there is one
     * @param v likewise
     * @param out set where it is by {@link Arrival#towards} or {@link Arrival#along}, and what arrives if nothing stands in the way by
     *         {@link Arrival#light}: what a white surface of diffusion 1 that faces it shows
     * @return whether anything arrives
     */
    boolean sample(Hit from, double u, double v, Arrival out);

    @Override
    default String name() {
        return "";
    }

    /** For lists; {@link #sample} alone says what arrives. */
    @Override
    default Rgb color() {
        return Rgb.WHITE;
    }

    /** For lists; {@link #sample} alone says what arrives. */
    @Override
    default double intensity() {
        return 1;
    }

    /** @throws UnsupportedOperationException unless it says otherwise: it is made in code, and changed there */
    @Override
    default Light named(String value) {
        throw new UnsupportedOperationException("a " + kind() + " is made in code, and is given its name there");
    }

    /** @throws UnsupportedOperationException as {@link #named} */
    @Override
    default Light withColor(Rgb value) {
        throw new UnsupportedOperationException("a " + kind() + " is made in code, and is given its colour there");
    }

    /** @throws UnsupportedOperationException as {@link #named} */
    @Override
    default Light withIntensity(double value) {
        throw new UnsupportedOperationException("a " + kind() + " is made in code, and is given its intensity there");
    }
}
