package cz.paprsek.shape.placed;

import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import java.util.Optional;

/** One primitive as placed in the world, alone or within a CSG body: what a boundary belongs to. */
public interface Part {
    /**
     * Completes a hit whose point is set: writes the normals.
     *
     * @param face which face was hit, the part's own numbering, not complemented
     */
    void describe(int face, Hit hit);

    /** The face by the numbering of the shape in its own space: the part's own may go by the axes of the world. */
    default int ownFace(int face) {
        return face;
    }

    /** The triangle that a face is, of a hit whose point is set; empty for what is not made of triangles. */
    default Optional<Corners> corners(int face, Hit hit) {
        return Optional.empty();
    }

    /**
     * Where in a triangle of a mesh a point lies.
     *
     * @param triangle its number, from 0
     * @param part the name of the mesh's part that it belongs to; empty if that has none
     * @param shares how much of each of its corners is in the point, together 1
     */
    record Corners(int triangle, String part, Vec3 shares) {}

    /** Writes into a hit whose point is set what the colour of the material is multiplied by there, linear light. */
    default void tint(int face, Hit hit) {
        hit.color(1, 1, 1);
    }

    /**
     * Writes u, v and the tangent of a hit whose point is set: only where somebody asks for it, for that takes long.
     *
     * @param face as above
     */
    void map(int face, Hit hit);
}
