package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.text.Numbers;
import java.util.Objects;
import java.util.OptionalDouble;

/**
 * A point that shines into a cone: all its light within the inner angle, none beyond the outer one, and between them 3t² − 2t³ of it, with t
 * going from 0 to 1 as the cosine does.
 *
 * @param name free text for people; empty for none, unique among the scene's lights otherwise
 * @param position world space
 * @param aim the way its light goes, or a point in the middle of it
 * @param color its colour
 * @param intensity factor on the linear colour, 0 to {@link #BRIGHTEST}
 * @param referenceDistance how far away the intensity arrives, scene units: at d it is (D/d)² times that; 0 for the same everywhere
 * @param innerAngle degrees from the middle, 0 to the outer one. {@value #USUAL_INNER} stands for none given: it gives way to a smaller outer one, as
 *         {@link #fullAngle} says
 * @param outerAngle degrees from the middle, above 0, at most 90
 */
@Element("A point that shines into a cone. Has either a direction or a target.")
public record SpotLight(
        @Attribute(value = Kind.NAME, means = "What the light is called; unique among the lights", otherwise = Attribute.NOTHING) String name,
        @Attribute(value = Kind.VECTOR, means = "Where it is") Vec3 position,
        Camera.Aim aim,
        @Attribute(value = Kind.COLOR, means = "sRGB, 0-255", otherwise = "255 255 255") Rgb color,
        @Attribute(value = Kind.INTENSITY, means = "Factor on the colour", otherwise = "1") double intensity,
        @Attribute(value = Kind.NOT_NEGATIVE, inForce = "fallOff", otherwise = "0",
                means = "Light falls with the square of the distance, and the intensity arrives at this one; at 0 it does not fall")
        double referenceDistance,
        @Attribute(value = Kind.CONE_ANGLE, inForce = "fullAngle", means = "Degrees from the middle within which all light arrives; at most the outer angle (if not given, 30 or the outer angle, whichever is smaller)", otherwise = "30")
        double innerAngle,
        @Attribute(value = Kind.CONE_ANGLE, means = "Degrees from the middle beyond which none does; above 0", otherwise = "45")
        double outerAngle) implements PlacedLight {
    /** What the inner angle is if it is not given, unless the outer one is smaller. */
    private static final double USUAL_INNER = 30;

    /** @throws IllegalArgumentException also if the target is where the light is */
    public SpotLight {
        LightRules.check(name, position, color, intensity);
        Objects.requireNonNull(aim, "aim");
        Require.sizeOrZero("light reference-distance", referenceDistance);
        Require.within("spot-light outer-angle", Require.positive("spot-light outer-angle", outerAngle), 0, 90);
        Require.notNegative("spot-light inner-angle", innerAngle);
        if (innerAngle != USUAL_INNER) {
            checkInner(innerAngle, outerAngle);
        }
        Require.that(!(aim instanceof Camera.Target target && target.point().equals(position)), "spot-light target must not be the light's own position");
    }

    /**
     * Checks an inner angle that is given, be it the usual one.
     *
     * @throws IllegalArgumentException if it is above the outer one
     */
    public static void checkInner(double innerAngle, double outerAngle) {
        Require.that(innerAngle <= outerAngle,
                "spot-light inner-angle must not be above the outer-angle of " + Numbers.text(outerAngle) + ", but is " + Numbers.text(innerAngle));
    }

    /** Degrees from the middle within which all light arrives: the inner angle, but at most the outer one. */
    public double fullAngle() {
        return Math.min(innerAngle, outerAngle);
    }

    /** A white one of intensity 1, without fall-off, of the usual angles. */
    public static SpotLight from(Vec3 position, Vec3 target) {
        return new SpotLight("", position, new Camera.Target(target), Rgb.WHITE, 1, 0, USUAL_INNER, 45);
    }

    /** The way the light in the middle goes, of length 1, world space. */
    public Vec3 direction() {
        return (aim instanceof Camera.Target target ? target.point().minus(position) : ((Camera.Direction) aim).vector()).normalized();
    }

    /** The distance at which the intensity arrives; empty for light that does not fall. */
    public OptionalDouble fallOff() {
        return referenceDistance > 0 ? OptionalDouble.of(referenceDistance) : OptionalDouble.empty();
    }

    @Override
    public SpotLight named(String value) {
        return new SpotLight(value, position, aim, color, intensity, referenceDistance, innerAngle, outerAngle);
    }

    /** At another place; one that has a target goes on shining at it. */
    @Override
    public SpotLight withPosition(Vec3 value) {
        return new SpotLight(name, value, aim, color, intensity, referenceDistance, innerAngle, outerAngle);
    }

    public SpotLight withAim(Camera.Aim value) {
        return new SpotLight(name, position, value, color, intensity, referenceDistance, innerAngle, outerAngle);
    }

    @Override
    public SpotLight withColor(Rgb value) {
        return new SpotLight(name, position, aim, value, intensity, referenceDistance, innerAngle, outerAngle);
    }

    @Override
    public SpotLight withIntensity(double value) {
        return new SpotLight(name, position, aim, color, value, referenceDistance, innerAngle, outerAngle);
    }

    /** With light that falls with the square of the distance; 0 for light that does not. */
    public SpotLight withReferenceDistance(double value) {
        return new SpotLight(name, position, aim, color, intensity, value, innerAngle, outerAngle);
    }

    /** With other angles, in degrees from the middle. */
    public SpotLight withAngles(double inner, double outer) {
        return new SpotLight(name, position, aim, color, intensity, referenceDistance, inner, outer);
    }
}
