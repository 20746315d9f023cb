/** Pictures that are put together of what was made by itself. */
@NullMarked
package cz.paprsek.render.join;

import org.jspecify.annotations.NullMarked;
