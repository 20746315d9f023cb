/** Triangles in large numbers: what readers of files make, and how rays meet them. */
package cz.paprsek.shape.mesh;
