/** What light falls on. */
@NullMarked
package cz.paprsek.render.film;

import org.jspecify.annotations.NullMarked;
