/** Pictures that follow a scene that changes. */
@NullMarked
package cz.paprsek.render.live;

import org.jspecify.annotations.NullMarked;
