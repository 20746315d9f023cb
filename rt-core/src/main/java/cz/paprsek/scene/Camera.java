package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import java.util.Objects;

/**
 * A camera: an eye, where it looks, and through what.
 *
 * @param name free text for people; empty for none, unique among the scene's cameras otherwise
 * @param position the eye, world space
 * @param aim where it looks: a direction, or a point it keeps in the middle
 * @param up the direction that is up in the picture; need not be perpendicular to the view. {@link Vec3#Y} stands for none given: it gives
 *         way to −z where the view goes straight down, and to +z where it goes straight up
 * @param lens how the world comes onto the picture
 */
@Element("An eye. Has either a direction or a target. The picture is what the first camera of a scene sees.")
public record Camera(
        @Attribute(value = Kind.NAME, means = "What the camera is called; unique among the cameras", otherwise = Attribute.NOTHING) String name,
        @Attribute(value = Kind.VECTOR, means = "Where it stands") Vec3 position,
        Aim aim,
        @Attribute(value = Kind.VECTOR, inForce = "upwards",
                means = "The direction that is up in the picture, not parallel to the view (if not given, and the view goes straight down, 0 0 -1; straight up, 0 0 1)",
                otherwise = "0 1 0") Vec3 up,
        @Attribute(value = Kind.WORD, name = "projection", means = "How the world comes onto the picture; spherical: all around", otherwise = "perspective")
        Lens lens) {
    /** How nearly parallel up and view may be: the sine of the smallest angle allowed between them. */
    private static final double PARALLEL = 1e-9;
    /** What is wrong with an up that is given along the view. */
    public static final String ALONG = "camera up must not be parallel to the view direction; turn one of them";

    /** From (0, 1, 5) towards −z, 45° high. */
    public static final Camera DEFAULT = looking(new Vec3(0, 1, 5), new Vec3(0, 0, -1));

    /** Where a camera looks. */
    public sealed interface Aim permits Direction, Target {}

    /** A direction in world space, of any length but 0. */
    public record Direction(
            @Attribute(value = Kind.VECTOR, name = "direction", means = "Where it looks, or the way light goes", otherwise = Attribute.NOTHING) Vec3 vector) implements Aim {
        public Direction {
            Require.that(!vector.equals(Vec3.ZERO), "direction must not be 0 0 0");
        }
    }

    /** A point in world space; the camera turns to it wherever it moves. */
    public record Target(
            @Attribute(value = Kind.VECTOR, name = "target", means = "A point in the middle of what it sees or lights", otherwise = Attribute.NOTHING) Vec3 point) implements Aim {
        public Target {
            Require.place("target", point);
        }
    }

    /**
     * @throws IllegalArgumentException if the view is undefined, as with the target at the eye or up along the view, or if there is an aperture
     *         but neither a focus nor a target
     */
    public Camera {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(lens, "lens");
        Require.place("camera position", position);
        Require.that(!up.equals(Vec3.ZERO), "camera up must not be 0 0 0");
        Require.that(!(aim instanceof Target t && t.point().equals(position)),
                "camera target must not be the camera's own position");
        Require.that(up.equals(Vec3.Y) || !isAlong(view(position, aim), up), ALONG);
        Require.that(aim instanceof Target || !(lens instanceof Lens.Perspective thin && thin.aperture() > 0 && thin.focus() == 0),
                "a camera with an aperture and no target needs a focus; say how far along the view it is sharp");
    }

    /** A camera without a name, through a pinhole. */
    public Camera(Vec3 position, Aim aim, Vec3 up, double fovy) {
        this("", position, aim, up, Lens.Perspective.DEFAULT.withFovy(fovy));
    }

    /** A camera that looks in a direction, with y up and 45° high. */
    public static Camera looking(Vec3 position, Vec3 direction) {
        return new Camera("", position, new Direction(direction), Vec3.Y, Lens.Perspective.DEFAULT);
    }

    /** A camera that looks at a point, with y up and 45° high. */
    public static Camera lookingAt(Vec3 position, Vec3 target) {
        return new Camera("", position, new Target(target), Vec3.Y, Lens.Perspective.DEFAULT);
    }

    public Camera named(String value) {
        return new Camera(value, position, aim, up, lens);
    }

    public Camera withPosition(Vec3 value) {
        return new Camera(name, value, aim, up, lens);
    }

    public Camera withAim(Aim value) {
        return new Camera(name, position, value, up, lens);
    }

    public Camera withUp(Vec3 value) {
        return new Camera(name, position, aim, value, lens);
    }

    public Camera withLens(Lens value) {
        return new Camera(name, position, aim, up, value);
    }

    /** With a perspective of that field of view; the lens stays as it is otherwise, if it is one. */
    public Camera withFovy(double degrees) {
        return withLens((lens instanceof Lens.Perspective perspective ? perspective : Lens.Perspective.DEFAULT).withFovy(degrees));
    }

    /** The distance along the view of what is sharp, scene units; endless if all is. */
    public double focus() {
        return !(lens instanceof Lens.Perspective thin) || thin.aperture() == 0 ? Double.POSITIVE_INFINITY
                : thin.focus() > 0 ? thin.focus() : ((Target) aim).point().minus(position).length();
    }

    /** Whether a view goes along a direction of any length but 0, or against it, so that it cannot be up in its picture. */
    public static boolean isAlong(Vec3 view, Vec3 direction) {
        return !(view.normalized().cross(direction.normalized()).length() > PARALLEL);
    }

    /** The view direction d, of length 1, world space. */
    public Vec3 forward() {
        return view(position, aim);
    }

    /** The picture's right r = d × up, of length 1, world space. */
    public Vec3 right() {
        return forward().cross(upwards().normalized()).normalized();
    }

    /** The picture's up u = r × d, of length 1, world space, perpendicular to the view. */
    public Vec3 trueUp() {
        return right().cross(forward());
    }

    /** What is up: as given, or what stands in for it; world space, of any length but 0. */
    public Vec3 upwards() {
        Vec3 d = forward();
        return !up.equals(Vec3.Y) || !isAlong(d, up) ? up : d.y() < 0 ? Vec3.Z.negated() : Vec3.Z;
    }

    private static Vec3 view(Vec3 position, Aim aim) {
        return (aim instanceof Target t ? t.point().minus(position) : ((Direction) aim).vector()).normalized();
    }
}
