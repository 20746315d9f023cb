package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.field.Field;
import cz.paprsek.shape.field.Implicit;
import cz.paprsek.shape.field.Sections;
import cz.paprsek.shape.outline.Drawn;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;
import cz.paprsek.text.Numbers;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;

/**
 * All points of a box where a formula is below 0, so closed by the faces of the box. No crossing of a ray is missed: bounds of the formula's values and
 * slopes say where there can be none.
 *
 * @param expression of x, y and z, own space, in the language of {@link cz.paprsek.formula.Formula}: angles in degrees
 * @param min the least x, y and z of the box
 * @param max the greatest
 */
@Element("All points of a box where a formula of x, y and z is below 0.")
public record Isosurface(
        @Attribute(value = Kind.EXPRESSION, means = "A formula of x, y and z, angles in degrees: below 0 inside", example = "x^2 + y^2 + z^2 - 0.25") String expression,
        @Attribute(value = Kind.VECTOR, means = "The corner of the box with the least x, y and z", otherwise = "-1 -1 -1", example = "-0.5 -0.5 -0.5") Vec3 min,
        @Attribute(value = Kind.VECTOR, means = "The corner with the greatest x, y and z", otherwise = "1 1 1", example = "0.5 0.5 0.5") Vec3 max) implements Solid {
    private static final int MOST_SECTIONS = 5;

    public Isosurface {
        Objects.requireNonNull(expression, "expression");
        Objects.requireNonNull(min, "min");
        Objects.requireNonNull(max, "max");
        Require.that(min.x() < max.x() && min.y() < max.y() && min.z() < max.z(),
                "isosurface min must be below max along every axis, but min is " + Numbers.text(min) + " and max is " + Numbers.text(max));
        Require.place("isosurface min", min);
        Require.place("isosurface max", max);
        field(expression);
    }

    private static Field field(String expression) {
        return new Field("isosurface expression", expression);
    }

    /** Whether the formula is nowhere below 0 in the box, as far as bounds of its values tell. */
    public boolean isEmpty() {
        Field field = field(expression);
        double[] room = field.newRoom();
        // Bounds are rounded outwards, also from 0.
        return !(room[field.within(new double[] {min.x(), min.y(), min.z(), max.x(), max.y(), max.z()}, 0, room)] < -Double.MIN_NORMAL);
    }

    @Override
    public Face face(int number) {
        return Face.ofBox(number);
    }

    @Override
    public Bounds bounds() {
        return Bounds.of(min, max);
    }

    /** The box, and sections of the surface across the axis that the view goes along most: as lines of height on a map. */
    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        return Stream.concat(Drawn.box(min, max).stream(), new Sections(field(expression), bounds(), Math.max(8, steps / 2)).across(along, MOST_SECTIONS).stream()).toList();
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        Field field = field(expression);
        return parts.add(part -> new Implicit(part, toWorld, bounds(), field));
    }
}
