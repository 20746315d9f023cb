/** Formulas of x, y and z as bodies: what bounds them along a ray, and where that meets them. */
@NullMarked
package cz.paprsek.shape.field;

import org.jspecify.annotations.NullMarked;
