/**
 * What surfaces are made of: colours, patterns, materials, as plain values.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
@NullMarked
package cz.paprsek.material;

import org.jspecify.annotations.NullMarked;
