package cz.paprsek.shape.mesh;

/**
 * A mesh whose seams have been closed.
 *
 * @param mesh the same if there were none
 * @param places how many places on open edges were moved to another next to them
 * @param kept how many sides of triangles are so short that their ends could be one place, and stay
 */
record Sewn(Triangles mesh, int places, int kept) {}
