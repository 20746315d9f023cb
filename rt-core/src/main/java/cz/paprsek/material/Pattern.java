package cz.paprsek.material;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import java.util.Locale;
import java.util.Objects;

/** What gives a surface its colour at each point. */
public sealed interface Pattern permits Pattern.Plain, Pattern.Checkerboard, Pattern.Checker, CustomPattern {

    /** The word for its kind: that of its element in a scene file, if it has one. */
    default String kind() {
        return getClass().getSimpleName().toLowerCase(Locale.ROOT);
    }

    /** Whether it goes by the place in a picture that covers the surface, u and v, rather than by the place in space. */
    default boolean isMapped() {
        return false;
    }

    /** One colour everywhere. */
    record Plain(
            @Attribute(value = Kind.COLOR, means = "sRGB, 0-255; not together with a pattern", otherwise = "255 255 255") Rgb color) implements Pattern {
        public Plain {
            Objects.requireNonNull(color, "color");
        }
    }

    /**
     * A board of columns × rows squares over a rectangle or disc; the square at the minimum corner is even.
     * Columns run along the surface's x, rows along its y. At most {@value #MOST} each way.
     */
    @Element("A board of columns x rows squares over a rectangle or a disc; the square at the minimum corner is even.")
    record Checkerboard(
            @Attribute(value = Kind.SQUARES, means = "Squares along x") int columns,
            @Attribute(value = Kind.SQUARES, means = "Squares along y") int rows,
            @Attribute(value = Kind.COLOR, means = "Colour of the even ones", otherwise = "255 255 255") Rgb even,
            @Attribute(value = Kind.COLOR, means = "Colour of the odd ones", otherwise = "0 0 0") Rgb odd) implements Pattern {
        public static final int MOST = 1_000_000;

        public Checkerboard {
            Objects.requireNonNull(even, "even");
            Objects.requireNonNull(odd, "odd");
            Require.within("checkerboard columns", columns, 1, MOST);
            Require.within("checkerboard rows", rows, 1, MOST);
        }

        @Override
        public boolean isMapped() {
            return true;
        }
    }

    /**
     * Cubes of alternating colour filling space, for any shape. The cubes have the given edge and one has its corner at
     * {@code origin}, in the space of the object that declares the material, before its placement; that one is even.
     */
    @Element("Cubes of alternating colour filling the space of the object that declares the material, before its placement.")
    record Checker(
            @Attribute(value = Kind.POSITIVE, means = "Edge of a cube") double size,
            @Attribute(value = Kind.VECTOR, means = "A corner of an even cube", otherwise = "0 0 0") Vec3 origin,
            @Attribute(value = Kind.COLOR, means = "Colour of the even ones", otherwise = "255 255 255") Rgb even,
            @Attribute(value = Kind.COLOR, means = "Colour of the odd ones", otherwise = "0 0 0") Rgb odd) implements Pattern {
        public Checker {
            Objects.requireNonNull(even, "even");
            Objects.requireNonNull(odd, "odd");
            Require.size("checker size", size);
            Require.place("checker origin", origin);
        }
    }
}
