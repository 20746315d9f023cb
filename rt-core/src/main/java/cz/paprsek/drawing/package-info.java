/** Explained rays as lines in three projections of the scene, and as SVG; the scale below a heat map. */
package cz.paprsek.drawing;
