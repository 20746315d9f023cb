/** Worksheets: pixels of a scene as exercises to be done with a pocket calculator, and their solutions. */
@NullMarked
package cz.paprsek.sheet;

import org.jspecify.annotations.NullMarked;
