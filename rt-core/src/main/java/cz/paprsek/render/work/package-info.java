/** Who renders: threads, and what they keep from one picture to the next. */
@NullMarked
package cz.paprsek.render.work;

import org.jspecify.annotations.NullMarked;
