/** How light is gathered along rays, and the same overheard: explaining. */
@NullMarked
package cz.paprsek.render.integrate;

import org.jspecify.annotations.NullMarked;
