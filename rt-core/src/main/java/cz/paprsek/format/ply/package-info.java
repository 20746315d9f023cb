/** PLY, in text and in bytes of either order: elements with named properties. No unit; axes as they are. */
package cz.paprsek.format.ply;
