package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;

/**
 * A pinhole camera.
 *
 * @param position the eye, world space
 * @param aim where it looks: a direction, or a point it keeps in the middle
 * @param up the direction that is up in the picture; need not be perpendicular to the view
 * @param fovy vertical field of view in degrees, above 0 and below 180
 */
@Element("The eye. Has either a direction or a target.")
public record Camera(
        @Attribute(value = Kind.VECTOR, means = "Where it stands") Vec3 position,
        Aim aim,
        @Attribute(value = Kind.VECTOR, means = "The direction that is up in the picture, not parallel to the view", otherwise = "0 1 0") Vec3 up,
        @Attribute(value = Kind.FOVY, means = "Vertical field of view in degrees", otherwise = "45") double fovy) {
    /** How nearly parallel up and view may be: the sine of the smallest angle allowed between them. */
    private static final double PARALLEL = 1e-9;

    /** From (0, 1, 5) towards −z, 45° high. */
    public static final Camera DEFAULT = looking(new Vec3(0, 1, 5), new Vec3(0, 0, -1));

    /** Where a camera looks. */
    public sealed interface Aim {}

    /** A direction in world space, of any length but 0. */
    public record Direction(
            @Attribute(value = Kind.VECTOR, name = "direction", means = "Where it looks", otherwise = Attribute.NOTHING) Vec3 vector) implements Aim {
        public Direction {
            Require.that(!vector.equals(Vec3.ZERO), "camera direction must not be 0 0 0");
        }
    }

    /** A point in world space; the camera turns to it wherever it moves. */
    public record Target(
            @Attribute(value = Kind.VECTOR, name = "target", means = "A point it keeps in the middle", otherwise = Attribute.NOTHING) Vec3 point) implements Aim {
        public Target {
            Require.place("camera target", point);
        }
    }

    /** @throws IllegalArgumentException if the view is undefined: fovy out of range, target at the eye, up along the view */
    public Camera {
        Require.place("camera position", position);
        Require.that(fovy > 0 && fovy < 180, "camera fovy must be above 0 and below 180 degrees, but is " + fovy);
        Require.that(!up.equals(Vec3.ZERO), "camera up must not be 0 0 0");
        Require.that(!(aim instanceof Target t && t.point().equals(position)),
                "camera target must not be the camera's own position");
        Require.that(view(position, aim).cross(up.normalized()).length() > PARALLEL,
                "camera up must not be parallel to the view direction; turn one of them");
    }

    /** A camera that looks in a direction, with y up and 45° high. */
    public static Camera looking(Vec3 position, Vec3 direction) {
        return new Camera(position, new Direction(direction), Vec3.Y, 45);
    }

    /** A camera that looks at a point, with y up and 45° high. */
    public static Camera lookingAt(Vec3 position, Vec3 target) {
        return new Camera(position, new Target(target), Vec3.Y, 45);
    }

    public Camera withPosition(Vec3 value) {
        return new Camera(value, aim, up, fovy);
    }

    public Camera withAim(Aim value) {
        return new Camera(position, value, up, fovy);
    }

    public Camera withUp(Vec3 value) {
        return new Camera(position, aim, value, fovy);
    }

    public Camera withFovy(double degrees) {
        return new Camera(position, aim, up, degrees);
    }

    /** The view direction d, of length 1, world space. */
    public Vec3 forward() {
        return view(position, aim);
    }

    /** The picture's right r = d × up, of length 1, world space. */
    public Vec3 right() {
        return forward().cross(up.normalized()).normalized();
    }

    /** The picture's up u = r × d, of length 1, world space, perpendicular to the view. */
    public Vec3 trueUp() {
        return right().cross(forward());
    }

    private static Vec3 view(Vec3 position, Aim aim) {
        return (aim instanceof Target t ? t.point().minus(position) : ((Direction) aim).vector()).normalized();
    }
}
