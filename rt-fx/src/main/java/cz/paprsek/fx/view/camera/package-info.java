/**
 * The live picture, as the scene's camera sees it, and the hand that moves the camera over it.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view.camera;
