/** Solids that stand in many places and are placed once: what they are, which those are, and how a ray meets one of their copies. */
@NullMarked
package cz.paprsek.shape.copied;

import org.jspecify.annotations.NullMarked;
