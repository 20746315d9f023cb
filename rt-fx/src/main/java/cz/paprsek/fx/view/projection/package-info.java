/**
 * The three projections: what is drawn, what is picked, and what the mouse and keys do there.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view.projection;
