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
import cz.paprsek.shape.placed.Flat;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.text.Numbers;
import java.util.List;
import java.util.Objects;

/** A rectangle in the plane z = 0, facing +z, seen from both sides. It has no inside. */
@Element("A rectangle in its plane z = 0, facing +z, seen from both sides. It has no inside.")
public record Rectangle(
        @Attribute(value = Kind.PAIR, name = "min", means = "Below max along both axes", example = "-0.5 -0.5") double minX,
        @Attribute(value = Kind.PAIR, name = "min", means = "") double minY,
        @Attribute(value = Kind.PAIR, name = "max", means = "Above min along both axes", example = "0.5 0.5") double maxX,
        @Attribute(value = Kind.PAIR, name = "max", means = "") double maxY) implements Shape {
    public Rectangle {
        Require.coordinate("rectangle min x", minX);
        Require.coordinate("rectangle min y", minY);
        Require.coordinate("rectangle max x", maxX);
        Require.coordinate("rectangle max y", maxY);
        Require.that(minX < maxX && minY < maxY, "rectangle min must be below max along both axes, but min is "
                + Numbers.text(minX) + " " + Numbers.text(minY) + " and max is " + Numbers.text(maxX) + " " + Numbers.text(maxY));
        Require.size("rectangle width", maxX - minX);
        Require.size("rectangle height", maxY - minY);
    }

    @Override
    public Bounds bounds() {
        return new Bounds(minX, minY, 0, maxX, maxY, 0);
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        return List.of(Drawn.loop(minX, minY, maxX, maxY, 0));
    }

    @Override
    public Surface place(Affine toWorld, Parts parts) {
        return parts.add(part -> new Placed(part, toWorld, this));
    }

    private static final class Placed extends Flat {
        private final Rectangle shape;

        Placed(int part, Affine toWorld, Rectangle shape) {
            super(part, toWorld, shape.bounds().transformed(toWorld));
            this.shape = shape;
        }

        @Override
        protected boolean holds(double x, double y) {
            return x >= shape.minX && x <= shape.maxX && y >= shape.minY && y <= shape.maxY;
        }

        @Override
        protected boolean isRectangle() {
            return true;
        }

        @Override
        protected double u(double x) {
            return (x - shape.minX) / (shape.maxX - shape.minX);
        }

        @Override
        protected double v(double y) {
            return (y - shape.minY) / (shape.maxY - shape.minY);
        }
    }
}
