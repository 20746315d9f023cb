/**
 * Vectors, maps and boxes: what geometry is written in. Knows nothing of colour or rays.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
@NullMarked
package cz.paprsek.math;

import org.jspecify.annotations.NullMarked;
