/** Outlines in the plane, how lines meet them, and the solids that are made of them, ready for rays; and the lines that shapes are drawn with. */
@NullMarked
package cz.paprsek.shape.outline;

import org.jspecify.annotations.NullMarked;
