package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import java.util.Objects;

/**
 * Where a shape stands in the space around it: scaled, then rotated, then moved.
 *
 * @param position where the shape's own origin goes, scene units
 * @param rotation degrees about x, then y, then z, each counter-clockwise seen from the positive end of its axis
 * @param scale factor along each of the shape's own axes; not 0, negative mirrors
 */
public record Placement(
        @Attribute(value = Kind.VECTOR, means = "Where its own origin goes", otherwise = "0 0 0") Vec3 position,
        @Attribute(value = Kind.ROTATION, means = "Degrees about x, then y, then z", otherwise = "0 0 0") Vec3 rotation,
        @Attribute(value = Kind.SCALE, means = "Applied before the rotation", otherwise = "1") Vec3 scale) {
    /** The pivot of bodies that are given none. */
    public static final Pivot MIDDLE = new Middle();
    public static final Placement NONE = new Placement(Vec3.ZERO, Vec3.ZERO, Vec3.ONE);

    /** What hands turn and scale a body about, for which its placement alone would do in pictures. */
    public sealed interface Pivot permits Middle, Point {
        /** Where that is in the space of a body of this shape; its origin if it has no end. */
        default Vec3 of(Shape shape) {
            Objects.requireNonNull(shape, "shape");
            Bounds box = shape.bounds();
            return box.isFinite() && !box.isEmpty() ? box.middle() : Vec3.ZERO;
        }
    }

    /** The middle of the body's box. */
    public record Middle() implements Pivot {}

    /** @param pivot in the body's own space, so that it goes along wherever that is placed */
    public record Point(@Attribute(value = Kind.VECTOR, means = "What hands turn and scale it about, in its own space; the middle of its box if not given", example = "0 0 0") Vec3 pivot)
            implements Pivot {
        /** @throws IllegalArgumentException if it is out of all proportion ({@link Require#LARGEST}) */
        public Point {
            Require.place("pivot", pivot);
        }

        @Override
        public Vec3 of(Shape shape) {
            Objects.requireNonNull(shape, "shape");
            return pivot;
        }
    }

    /** @throws IllegalArgumentException if a scale is 0, or a number is out of all proportion ({@link Require#LARGEST}) */
    public Placement {
        Objects.requireNonNull(rotation, "rotation");
        Require.place("position", position);
        Require.scale(scale);
    }

    public static Placement at(double x, double y, double z) {
        return NONE.withPosition(new Vec3(x, y, z));
    }

    public Placement withPosition(Vec3 value) {
        return new Placement(value, rotation, scale);
    }

    public Placement withRotation(Vec3 degrees) {
        return new Placement(position, degrees, scale);
    }

    public Placement withScale(Vec3 value) {
        return new Placement(position, rotation, value);
    }

    /** The map from the shape's own space to the space around it. */
    public Affine toParent() {
        return rotation.equals(Vec3.ZERO) ? Affine.scalingAndMoving(scale, position)
                : Affine.translation(position).after(Affine.rotation(rotation)).after(Affine.scaling(scale));
    }
}
