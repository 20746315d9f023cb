/**
 * Scenes for POV-Ray, an independent renderer.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.pov;
