/** Wavefront's OBJ, and the materials (MTL) beside it. No unit; y up, by custom. */
@NullMarked
package cz.paprsek.format.obj;

import org.jspecify.annotations.NullMarked;
