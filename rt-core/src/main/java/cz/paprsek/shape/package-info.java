/**
 * Shapes, CSG and placement, and how a ray meets them. Knows nothing of lights, files or threads.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
@NullMarked
package cz.paprsek.shape;

import org.jspecify.annotations.NullMarked;
