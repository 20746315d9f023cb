/** Shapes as placed in the world, and how a ray meets them: what all primitives have in common. */
package cz.paprsek.shape.placed;
