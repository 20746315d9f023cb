package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import java.util.OptionalDouble;

/**
 * A point that shines evenly in all directions.
 *
 * @param name free text for people; empty for none, unique among the scene's lights otherwise
 * @param position world space
 * @param color its colour
 * @param intensity factor on the linear colour, 0 to {@link #BRIGHTEST}
 * @param referenceDistance how far away the intensity arrives, scene units: at d it is (D/d)² times that; 0 for the same everywhere
 */
@Element("A point that shines evenly in all directions.")
public record PointLight(
        @Attribute(value = Kind.NAME, means = "What the light is called; unique among the lights", otherwise = Attribute.NOTHING) String name,
        @Attribute(value = Kind.VECTOR, means = "Where it is") Vec3 position,
        @Attribute(value = Kind.COLOR, means = "sRGB, 0-255", otherwise = "255 255 255") Rgb color,
        @Attribute(value = Kind.INTENSITY, means = "Factor on the colour", otherwise = "1") double intensity,
        @Attribute(value = Kind.NOT_NEGATIVE, inForce = "fallOff", otherwise = "0",
                means = "Light falls with the square of the distance, and the intensity arrives at this one; at 0 it does not fall")
        double referenceDistance) implements PlacedLight {
    public PointLight {
        LightRules.check(name, position, color, intensity);
        Require.sizeOrZero("light reference-distance", referenceDistance);
    }

    /** The distance at which the intensity arrives; empty for light that does not fall. */
    public OptionalDouble fallOff() {
        return referenceDistance > 0 ? OptionalDouble.of(referenceDistance) : OptionalDouble.empty();
    }

    @Override
    public PointLight named(String value) {
        return new PointLight(value, position, color, intensity, referenceDistance);
    }

    @Override
    public PointLight withPosition(Vec3 value) {
        return new PointLight(name, value, color, intensity, referenceDistance);
    }

    @Override
    public PointLight withColor(Rgb value) {
        return new PointLight(name, position, value, intensity, referenceDistance);
    }

    @Override
    public PointLight withIntensity(double value) {
        return new PointLight(name, position, color, value, referenceDistance);
    }

    /** With light that falls with the square of the distance; 0 for light that does not. */
    public PointLight withReferenceDistance(double value) {
        return new PointLight(name, position, color, intensity, value);
    }
}
