package cz.paprsek.shape;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.outline.Drawn;
import cz.paprsek.shape.placed.ByHand;
import cz.paprsek.shape.placed.Made;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.text.MadeInCode;
import java.util.List;
import java.util.Objects;

/**
 * A figure without an inside that is made in code rather than read from a file: it says in its own space where lines cross it, and what lies
 * where. {@link CustomSolid} is one with an inside. Must be immutable; any number of workers ask it at once. Scene files and POV-Ray cannot hold it.
 *
 * <p>{@code ShapeCheck} tries a shape and says what is wrong with it.
 */
public non-sealed interface CustomShape extends Shape, ByHand {

    /** The word for its kind in lists, explanations and messages: the name of its class unless it says otherwise. */
    @Override
    default String kind() {
        return MadeInCode.kind(this);
    }

    /**
     * Calls {@link Line#cross} for every place where the line crosses the shape, from minus to plus infinity, whatever the length of its direction;
     * of a figure in any order.
     */
    @Override
    void cross(Line line);

    /**
     * Sets the normal of a place where a line was said to cross.
     *
     * @param face that the line was said to cross
     * @param hit with the point in the shape's own space; {@link Hit#normal(double, double, double)} is to be called, also in that space: out of a solid, and always to the same side of a figure
     */
    @Override
    void normal(int face, Hit hit);

    /**
     * Sets the place in a picture that covers the shape, and the tangent, by {@link Hit#map} or one of its like: u to the right and v up, as seen from
     * outside. Without an own one the shape is mapped as a globe about the middle of its bounds.
     *
     * @param face as for the normal
     * @param hit with the point in the shape's own space
     */
    @Override
    default void map(int face, Hit hit) {
        Objects.requireNonNull(hit, "hit");
        Made.mapGlobe(this, face, hit);
    }

    /** About how long it takes to meet a line, in units of what a sphere takes. */
    @Override
    default double cost() {
        return 10;
    }

    @Override
    Bounds bounds();

    /** The edges of its box, unless it says otherwise. */
    @Override
    default List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        Bounds box = bounds();
        return box.isFinite() ? Drawn.box(new Vec3(box.minX(), box.minY(), box.minZ()), new Vec3(box.maxX(), box.maxY(), box.maxZ())) : List.of();
    }

    @Override
    default Surface place(Affine toWorld, Parts parts) {
        return new Made.Figure(parts.add(part -> new Made(part, toWorld, this)));
    }
}
