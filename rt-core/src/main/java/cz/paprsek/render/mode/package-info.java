/** What pictures may show, other than light. */
@NullMarked
package cz.paprsek.render.mode;

import org.jspecify.annotations.NullMarked;
