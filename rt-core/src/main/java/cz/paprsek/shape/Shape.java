package cz.paprsek.shape;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;

/** The geometry of one thing, in its own space: a {@link Solid} or a surface without an inside. */
public sealed interface Shape permits Solid, Rectangle, Disc {

    /** The box around the shape in its own space; may be unbounded. */
    Bounds bounds();

    /**
     * The shape made ready for rays.
     *
     * @param toWorld from the shape's own space to the world
     * @param parts where its primitives are registered
     */
    Surface place(Affine toWorld, Parts parts);
}
