package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Placement;
import java.util.Objects;

/**
 * A rectangle or disc that shines to one side, alike from everywhere and in all directions: its radiance is π·I·D²/A, with I the colour times
 * the intensity, D the reference distance and A its area. So from afar, straight before it, it is as a point light of the same intensity and
 * reference distance.
 *
 * @param name free text for people; empty for none, unique among the scene's lights otherwise
 * @param position of its middle, world space
 * @param rotation degrees about x, then y, then z; unturned it lies in the plane z = 0 and shines towards +z
 * @param form how large it is
 * @param color its colour
 * @param intensity factor on the linear colour, 0 to {@link #BRIGHTEST}
 * @param referenceDistance how far away the intensity arrives, scene units
 * @param samples how many shadow rays a point sends, 1 to {@link #MOST_SAMPLES}
 * @param visible whether rays meet it: a black body, which shows its radiance on the side it shines to and keeps the light of others off
 */
@Element("A rectangle or disc in the plane z = 0 that shines towards +z. Has either a size or a radius.")
public record AreaLight(
        @Attribute(value = Kind.NAME, means = "What the light is called; unique among the lights", otherwise = Attribute.NOTHING) String name,
        @Attribute(value = Kind.VECTOR, means = "Where its middle is") Vec3 position,
        @Attribute(value = Kind.ROTATION, means = "Degrees about x, then y, then z", otherwise = "0 0 0") Vec3 rotation,
        Form form,
        @Attribute(value = Kind.COLOR, means = "sRGB, 0-255", otherwise = "255 255 255") Rgb color,
        @Attribute(value = Kind.INTENSITY, means = "Factor on the colour", otherwise = "1") double intensity,
        @Attribute(value = Kind.POSITIVE, means = "Where the intensity arrives, straight before it", otherwise = "1") double referenceDistance,
        @Attribute(value = Kind.LIGHT_SAMPLES, means = "Shadow rays a point", otherwise = "16") int samples,
        @Attribute(value = Kind.FLAG, means = "Whether it is seen, and casts shadows of other lights", otherwise = "true") boolean visible) implements PlacedLight {

    /** How large it is. */
    public sealed interface Form permits Size, Radius {
        /** Square scene units. */
        double area();
    }

    /** A rectangle about its middle. */
    public record Size(
            @Attribute(value = Kind.POSITIVE_PAIR, name = "size", means = "Width and height of a rectangle about its middle", otherwise = Attribute.NOTHING) double width,
            @Attribute(value = Kind.POSITIVE_PAIR, name = "size", means = "Width and height of a rectangle about its middle", otherwise = Attribute.NOTHING) double height)
            implements Form {
        public Size {
            Require.size("area-light width", width);
            Require.size("area-light height", height);
        }

        @Override
        public double area() {
            return width * height;
        }
    }

    /** A disc about its middle. */
    public record Radius(
            @Attribute(value = Kind.POSITIVE, means = "Of a disc about its middle", otherwise = Attribute.NOTHING) double radius) implements Form {
        public Radius {
            Require.size("area-light radius", radius);
        }

        @Override
        public double area() {
            return Math.PI * radius * radius;
        }
    }

    public AreaLight {
        LightRules.check(name, position, color, intensity);
        Require.place("light rotation", rotation);
        Objects.requireNonNull(form, "form");
        LightRules.checkSized(samples, referenceDistance);
    }

    /** A white rectangle of intensity 1, unturned. */
    public static AreaLight rectangle(Vec3 position, double width, double height) {
        return new AreaLight("", position, Vec3.ZERO, new Size(width, height), Rgb.WHITE, 1, 1, 16, true);
    }

    /** A white disc of intensity 1, unturned. */
    public static AreaLight disc(Vec3 position, double radius) {
        return new AreaLight("", position, Vec3.ZERO, new Radius(radius), Rgb.WHITE, 1, 1, 16, true);
    }

    /** Turned so that it shines straight at a point; as it is if that is its own position. */
    public AreaLight shiningAt(Vec3 target) {
        Vec3 way = target.minus(position);
        if (way.equals(Vec3.ZERO)) {
            return this;
        }
        Vec3 d = way.normalized();
        return withRotation(new Vec3(StrictMath.toDegrees(StrictMath.asin(Math.max(-1, Math.min(1, -d.y())))), StrictMath.toDegrees(StrictMath.atan2(d.x(), d.z())), 0));
    }

    /** Where it stands. */
    public Placement placement() {
        return new Placement(position, rotation, Vec3.ONE);
    }

    /** The way it shines, of length 1, world space. */
    public Vec3 direction() {
        return placement().toParent().direction(Vec3.Z);
    }

    @Override
    public AreaLight named(String value) {
        return new AreaLight(value, position, rotation, form, color, intensity, referenceDistance, samples, visible);
    }

    @Override
    public AreaLight withPosition(Vec3 value) {
        return new AreaLight(name, value, rotation, form, color, intensity, referenceDistance, samples, visible);
    }

    public AreaLight withRotation(Vec3 degrees) {
        return new AreaLight(name, position, degrees, form, color, intensity, referenceDistance, samples, visible);
    }

    public AreaLight withForm(Form value) {
        return new AreaLight(name, position, rotation, value, color, intensity, referenceDistance, samples, visible);
    }

    @Override
    public AreaLight withColor(Rgb value) {
        return new AreaLight(name, position, rotation, form, value, intensity, referenceDistance, samples, visible);
    }

    @Override
    public AreaLight withIntensity(double value) {
        return new AreaLight(name, position, rotation, form, color, value, referenceDistance, samples, visible);
    }

    public AreaLight withReferenceDistance(double value) {
        return new AreaLight(name, position, rotation, form, color, intensity, value, samples, visible);
    }

    public AreaLight withSamples(int value) {
        return new AreaLight(name, position, rotation, form, color, intensity, referenceDistance, value, visible);
    }

    public AreaLight withVisible(boolean value) {
        return new AreaLight(name, position, rotation, form, color, intensity, referenceDistance, samples, value);
    }
}
