/** What a camera sees the world with: one class for each lens. */
@NullMarked
package cz.paprsek.render.eye;

import org.jspecify.annotations.NullMarked;
