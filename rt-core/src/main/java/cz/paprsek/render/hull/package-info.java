/** Bodies outside of the tree: the walls of a room, of which a ray meets but the one through which it leaves, bodies without end, and a few that are met as they come. */
@NullMarked
package cz.paprsek.render.hull;

import org.jspecify.annotations.NullMarked;
