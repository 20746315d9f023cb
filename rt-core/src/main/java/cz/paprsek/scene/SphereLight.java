package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;

/**
 * A ball that shines alike from everywhere and in all directions: its radiance is I·D²/r², with I the colour times the intensity and D the
 * reference distance. So what arrives of it is as of a point light in its middle, but for soft shadows.
 *
 * @param name free text for people; empty for none, unique among the scene's lights otherwise
 * @param position of its middle, world space
 * @param radius scene units; inside of it, it gives no light
 * @param color its colour
 * @param intensity factor on the linear colour, 0 to {@link #BRIGHTEST}
 * @param referenceDistance how far from its middle the intensity arrives, scene units
 * @param samples how many shadow rays a point sends, 1 to {@link #MOST_SAMPLES}
 * @param visible whether rays meet it: a black body, which shows its radiance and keeps the light of others off
 */
@Element("A ball that shines to all sides.")
public record SphereLight(
        @Attribute(value = Kind.NAME, means = "What the light is called; unique among the lights", otherwise = Attribute.NOTHING) String name,
        @Attribute(value = Kind.VECTOR, means = "Where its middle is") Vec3 position,
        @Attribute(value = Kind.POSITIVE, means = "Above 0") double radius,
        @Attribute(value = Kind.COLOR, means = "sRGB, 0-255", otherwise = "255 255 255") Rgb color,
        @Attribute(value = Kind.INTENSITY, means = "Factor on the colour", otherwise = "1") double intensity,
        @Attribute(value = Kind.POSITIVE, means = "How far from its middle the intensity arrives", otherwise = "1") double referenceDistance,
        @Attribute(value = Kind.LIGHT_SAMPLES, means = "Shadow rays a point", otherwise = "16") int samples,
        @Attribute(value = Kind.FLAG, means = "Whether it is seen, and casts shadows of other lights", otherwise = "true") boolean visible) implements PlacedLight {
    public SphereLight {
        LightRules.check(name, position, color, intensity);
        Require.size("sphere-light radius", radius);
        LightRules.checkSized(samples, referenceDistance);
    }

    /** A white one of intensity 1. */
    public static SphereLight of(Vec3 position, double radius) {
        return new SphereLight("", position, radius, Rgb.WHITE, 1, 1, 16, true);
    }

    @Override
    public SphereLight named(String value) {
        return new SphereLight(value, position, radius, color, intensity, referenceDistance, samples, visible);
    }

    @Override
    public SphereLight withPosition(Vec3 value) {
        return new SphereLight(name, value, radius, color, intensity, referenceDistance, samples, visible);
    }

    public SphereLight withRadius(double value) {
        return new SphereLight(name, position, value, color, intensity, referenceDistance, samples, visible);
    }

    @Override
    public SphereLight withColor(Rgb value) {
        return new SphereLight(name, position, radius, value, intensity, referenceDistance, samples, visible);
    }

    @Override
    public SphereLight withIntensity(double value) {
        return new SphereLight(name, position, radius, color, value, referenceDistance, samples, visible);
    }

    public SphereLight withReferenceDistance(double value) {
        return new SphereLight(name, position, radius, color, intensity, value, samples, visible);
    }

    public SphereLight withSamples(int value) {
        return new SphereLight(name, position, radius, color, intensity, referenceDistance, value, visible);
    }

    public SphereLight withVisible(boolean value) {
        return new SphereLight(name, position, radius, color, intensity, referenceDistance, samples, value);
    }
}
