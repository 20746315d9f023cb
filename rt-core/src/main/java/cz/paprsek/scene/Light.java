package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import java.util.Objects;

/**
 * A point that shines evenly in all directions, without fall-off.
 *
 * @param name free text for people; empty for none, unique among the scene's lights otherwise
 * @param position world space
 * @param color its colour
 * @param intensity factor on the linear colour, 0 to {@link #BRIGHTEST}
 */
@Element(name = "point-light", value = "A point that shines evenly in all directions, without fall-off.")
public record Light(
        @Attribute(value = Kind.NAME, means = "What the light is called; unique among the lights", otherwise = Attribute.NOTHING) String name,
        @Attribute(value = Kind.VECTOR, means = "Where it is") Vec3 position,
        @Attribute(value = Kind.COLOR, means = "sRGB, 0-255", otherwise = "255 255 255") Rgb color,
        @Attribute(value = Kind.INTENSITY, means = "Factor on the colour", otherwise = "1") double intensity) {
    /** The greatest intensity: no picture of floats holds much more. */
    public static final double BRIGHTEST = 1e12;

    public Light {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(color, "color");
        Require.place("light position", position);
        Require.notNegative("light intensity", intensity);
        Require.within("light intensity", intensity, 0, BRIGHTEST);
    }

    /** A white light of intensity 1. */
    public static Light at(double x, double y, double z) {
        return new Light("", new Vec3(x, y, z), Rgb.WHITE, 1);
    }

    public Light named(String value) {
        return new Light(value, position, color, intensity);
    }

    public Light withPosition(Vec3 value) {
        return new Light(name, value, color, intensity);
    }

    public Light withColor(Rgb value) {
        return new Light(name, position, value, intensity);
    }

    public Light withIntensity(double value) {
        return new Light(name, position, color, value);
    }
}
