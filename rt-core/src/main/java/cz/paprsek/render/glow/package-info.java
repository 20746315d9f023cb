/** Lights and sky as they are seen: what eyes and paths meet of them, and how a sky is looked for. */
@NullMarked
package cz.paprsek.render.glow;

import org.jspecify.annotations.NullMarked;
