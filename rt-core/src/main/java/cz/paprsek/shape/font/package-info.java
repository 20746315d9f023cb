/** Letters: TrueType fonts read from their bytes alone, those that are shipped, and lines of text set in them. */
package cz.paprsek.shape.font;
