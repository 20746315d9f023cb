/**
 * Scenes for POV-Ray, an independent renderer.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
@NullMarked
package cz.paprsek.pov;

import org.jspecify.annotations.NullMarked;
