/** Explained rays as lines in three projections of the scene, and as SVG. */
package cz.paprsek.drawing;
