/**
 * What is allowed in a scene, but hardly what its author meant.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
@NullMarked
package cz.paprsek.warning;

import org.jspecify.annotations.NullMarked;
