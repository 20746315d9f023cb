package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;

/**
 * Light from infinitely far away: parallel, or from a disc in the sky that is I/sin²(angle/2) bright, I the colour times the intensity.
 *
 * @param name free text for people; empty for none, unique among the scene's lights otherwise
 * @param direction the way its light goes, of any length but 0, world space
 * @param color its colour
 * @param intensity factor on the linear colour, 0 to {@link #BRIGHTEST}; what arrives where nothing is in the way
 * @param angle the diameter of its disc in degrees, 0 to 180; the shadows of a disc are soft
 * @param visible whether rays that hit nothing see its disc, in place of the background
 */
@Element("Light from infinitely far away.")
public record SunLight(
        @Attribute(value = Kind.NAME, means = "What the light is called; unique among the lights", otherwise = Attribute.NOTHING) String name,
        @Attribute(value = Kind.VECTOR, means = "The way its light goes") Vec3 direction,
        @Attribute(value = Kind.COLOR, means = "sRGB, 0-255", otherwise = "255 255 255") Rgb color,
        @Attribute(value = Kind.INTENSITY, means = "Factor on the colour", otherwise = "1") double intensity,
        @Attribute(value = Kind.DISC_ANGLE, means = "Diameter of its disc in degrees, whose shadows are soft; at 0 light is parallel", otherwise = "0") double angle,
        @Attribute(value = Kind.FLAG, means = "Whether its disc is seen in the sky", otherwise = "false") boolean visible) implements Light {
    /** Shadow rays that a point sends to a disc; to a sun without one it sends one. */
    public static final int SAMPLES = 16;

    public SunLight {
        LightRules.check(name, color, intensity);
        Require.place("sun-light direction", direction);
        Require.that(!direction.equals(Vec3.ZERO), "sun-light direction must not be 0 0 0");
        Require.within("sun-light angle", angle, 0, 180);
    }

    /** A white one of intensity 1, whose light is parallel. */
    public static SunLight along(double x, double y, double z) {
        return new SunLight("", new Vec3(x, y, z), Rgb.WHITE, 1, 0, false);
    }

    @Override
    public SunLight named(String value) {
        return new SunLight(value, direction, color, intensity, angle, visible);
    }

    public SunLight withDirection(Vec3 value) {
        return new SunLight(name, value, color, intensity, angle, visible);
    }

    @Override
    public SunLight withColor(Rgb value) {
        return new SunLight(name, direction, value, intensity, angle, visible);
    }

    @Override
    public SunLight withIntensity(double value) {
        return new SunLight(name, direction, color, value, angle, visible);
    }

    /** With a disc of that many degrees across, seen or not. */
    public SunLight withDisc(double degrees, boolean seen) {
        return new SunLight(name, direction, color, intensity, degrees, seen);
    }
}
