/** Tracers overheard: what becomes of rays, written down for explaining, and what the light of a pixel is made of. */
@NullMarked
package cz.paprsek.render.account;

import org.jspecify.annotations.NullMarked;
