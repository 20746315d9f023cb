/** Films: pictures one after the other, in one file. */
@NullMarked
package cz.paprsek.image.film;

import org.jspecify.annotations.NullMarked;
