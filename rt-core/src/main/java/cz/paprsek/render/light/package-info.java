/** Lights as points of surfaces see them: one class for each kind. */
@NullMarked
package cz.paprsek.render.light;

import org.jspecify.annotations.NullMarked;
