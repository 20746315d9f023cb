/** The world as rays meet it: bodies, what they are made of, and what lies around a ray. */
@NullMarked
package cz.paprsek.render.surface;

import org.jspecify.annotations.NullMarked;
