/**
 * Scenes for POV-Ray, an independent renderer: the exporter, and a way to run the program where it is installed.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.pov;
