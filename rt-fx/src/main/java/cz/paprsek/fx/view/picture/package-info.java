/**
 * Pictures on the screen: the pixels, what is under the mouse, and the files they go to.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view.picture;
