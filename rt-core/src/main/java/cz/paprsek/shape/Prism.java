package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.outline.Drawn;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Sided;
import cz.paprsek.shape.placed.Volume;
import java.util.List;
import java.util.Objects;

/** A closed prism of equal sides about the y axis, from y = 0 to y = height. A corner lies towards +x. */
@Element("A closed prism of equal sides about its y axis, from y = 0.")
public record Prism(
        @Attribute(value = Kind.SIDES, means = "How many there are around it", otherwise = "6") int sides,
        @Attribute(value = Kind.POSITIVE, means = "From the axis to the corners, of which one lies towards +x", example = "0.4") double radius,
        @Attribute(value = Kind.POSITIVE, means = "Above 0", example = "1") double height) implements Solid {
    public Prism {
        Require.within("prism sides", sides, (int) Kind.SIDES.least(), (int) Kind.SIDES.most());
        Require.size("prism radius", radius);
        Require.size("prism height", height);
    }

    @Override
    public Face face(int number) {
        return faceOf(number);
    }

    /** A face of what has flat sides, by its number. */
    static Face faceOf(int number) {
        return number >= Sided.FIRST_SIDE ? Face.SIDE : number == Sided.BOTTOM ? Face.BOTTOM : Face.TOP;
    }

    @Override
    public Bounds bounds() {
        return Sided.worldBounds(Affine.IDENTITY, sides, radius, radius, height);
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        return Drawn.sided(sides, radius, radius, height);
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return parts.add(part -> new Sided(part, toWorld, sides, radius, radius, height));
    }
}
