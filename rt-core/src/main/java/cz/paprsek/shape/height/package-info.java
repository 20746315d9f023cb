/** Heights over a grid: relief that is met cell by cell. */
@NullMarked
package cz.paprsek.shape.height;

import org.jspecify.annotations.NullMarked;
