/** The walls of a room, of which a ray meets but the one through which it leaves. */
@NullMarked
package cz.paprsek.render.hull;

import org.jspecify.annotations.NullMarked;
