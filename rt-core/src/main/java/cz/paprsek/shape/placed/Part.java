package cz.paprsek.shape.placed;

import cz.paprsek.ray.Hit;

/** One primitive as placed in the world, alone or within a CSG body: what a boundary belongs to. */
public interface Part {
    /**
     * Completes a hit whose point is set: writes the normal, and u and v on a flat surface.
     *
     * @param face which face was hit, the part's own numbering, not complemented
     */
    void describe(int face, Hit hit);
}
