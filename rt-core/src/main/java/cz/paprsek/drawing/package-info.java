/** Explained rays as lines in three projections of the scene, and as SVG; the scale below a heat map. */
@NullMarked
package cz.paprsek.drawing;

import org.jspecify.annotations.NullMarked;
