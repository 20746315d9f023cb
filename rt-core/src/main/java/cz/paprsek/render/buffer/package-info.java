/** What stands before lights, found once for all shadow rays. */
@NullMarked
package cz.paprsek.render.buffer;

import org.jspecify.annotations.NullMarked;
