/** Letters: TrueType fonts read from their bytes alone, those that are shipped, and lines of text set in them. */
@NullMarked
package cz.paprsek.shape.font;

import org.jspecify.annotations.NullMarked;
