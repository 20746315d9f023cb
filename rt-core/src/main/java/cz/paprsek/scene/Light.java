package cz.paprsek.scene;

import cz.paprsek.attribute.ElementTable;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;

/**
 * What gives light: a record for each kind. An intensity I is light in the unit of pictures: a white surface of diffusion 1 that faces the
 * light, where I arrives, is I bright.
 */
public sealed interface Light permits PlacedLight, SunLight, CustomLight {
    /** The greatest intensity: no picture of floats holds much more. */
    double BRIGHTEST = 1e12;

    /** A white point of intensity 1, without fall-off. */
    static PointLight at(double x, double y, double z) {
        return new PointLight("", new Vec3(x, y, z), Rgb.WHITE, 1, 0);
    }

    /** The word for it in files: {@code point-light}. */
    default String kind() {
        return ElementTable.name(getClass());
    }

    /** Free text for people; empty for none, unique among the scene's lights otherwise. */
    String name();

    Rgb color();

    /** Factor on the linear colour, 0 to {@link #BRIGHTEST}. */
    double intensity();

    Light named(String value);

    Light withColor(Rgb value);

    Light withIntensity(double value);
}
