/** Tries shapes that were made in code, for their makers' tests. */
@NullMarked
package cz.paprsek.shape.check;

import org.jspecify.annotations.NullMarked;
