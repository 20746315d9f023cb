/** Shapes as placed in the world, and how a ray meets them: what all primitives have in common. */
@NullMarked
package cz.paprsek.shape.placed;

import org.jspecify.annotations.NullMarked;
