package cz.paprsek.shape;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Surface;
import java.util.List;
import java.util.Locale;

/** The geometry of one thing, in its own space: a {@link Solid} or a surface without an inside. */
public sealed interface Shape permits Solid, Rectangle, Disc, CustomShape {

    /** The word for its kind: that of its element in a scene file. */
    default String kind() {
        return getClass().getSimpleName().toLowerCase(Locale.ROOT);
    }

    /** A face of a shape. */
    enum Face {
        /** That of a shape which has no others. */
        ONLY("surface"),
        SIDE("side"), BOTTOM("bottom"), TOP("top"),
        MINUS_X("−x face"), PLUS_X("+x face"), MINUS_Y("−y face"), PLUS_Y("+y face"), MINUS_Z("−z face"), PLUS_Z("+z face");

        private final String text;

        Face(String text) {
            this.text = text;
        }

        /** Its name in English. */
        public String text() {
            return text;
        }

        /** The face of a body that its box closes: 1 to 6 are those of the box, −x, +x, −y and so on; all others are the body's own surface. */
        public static Face ofBox(int number) {
            return switch (number) {
                case 1 -> MINUS_X;
                case 2 -> PLUS_X;
                case 3 -> MINUS_Y;
                case 4 -> PLUS_Y;
                case 5 -> MINUS_Z;
                case 6 -> PLUS_Z;
                default -> ONLY;
            };
        }

        /** The direction a face of a block looks in, such as {@code −x}. */
        public String axis() {
            return text.substring(0, 2);
        }
    }

    /** The face of a number, by its own numbering. */
    default Face face(int number) {
        return Face.ONLY;
    }

    /** Whether it encloses space, so that it can be an operand and have a medium inside: of a {@link Mesh} that depends on its triangles. */
    default boolean hasInside() {
        return this instanceof Solid;
    }

    /** The box around the shape in its own space; may be unbounded. */
    Bounds bounds();

    /**
     * The lines that draw the shape as seen from far away: its silhouette and its edges, in its own space. None for an operation, whose
     * operands draw it.
     *
     * @param along where the view goes, own space, any length but 0
     * @param steps of how many straight pieces a full circle is made
     */
    List<Curve> outline(Vec3 along, int steps);

    /**
     * The shape made ready for rays.
     *
     * @param toWorld from the shape's own space to the world
     * @param parts where its primitives are registered
     */
    Surface place(Affine toWorld, Parts parts);
}
