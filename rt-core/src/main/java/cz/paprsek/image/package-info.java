/**
 * Pictures in linear light, and the files they are written to.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
@NullMarked
package cz.paprsek.image;

import org.jspecify.annotations.NullMarked;
