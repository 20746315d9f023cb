/** Triangles in large numbers: what readers of files make, and how rays meet them. */
@NullMarked
package cz.paprsek.shape.mesh;

import org.jspecify.annotations.NullMarked;
