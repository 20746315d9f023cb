package cz.paprsek.shape.placed;

import cz.paprsek.ray.Hit;

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

    /**
     * Writes u, v and the tangent of a hit whose point is set: only where somebody asks for it, for that takes long.
     *
     * @param face as above
     */
    void map(int face, Hit hit);
}
