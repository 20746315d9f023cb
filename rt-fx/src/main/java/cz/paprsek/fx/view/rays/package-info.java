/**
 * Explained rays as lines on any canvas.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view.rays;
