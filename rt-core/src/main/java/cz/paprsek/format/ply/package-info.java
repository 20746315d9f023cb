/** PLY, in text and in bytes of either order: elements with named properties. No unit; axes as they are. */
@NullMarked
package cz.paprsek.format.ply;

import org.jspecify.annotations.NullMarked;
