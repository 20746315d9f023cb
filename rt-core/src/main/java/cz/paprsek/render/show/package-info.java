/** How pictures are made that show something else than light. */
@NullMarked
package cz.paprsek.render.show;

import org.jspecify.annotations.NullMarked;
