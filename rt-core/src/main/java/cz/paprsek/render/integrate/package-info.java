/** How light is gathered along rays, and the same overheard: explaining. */
package cz.paprsek.render.integrate;
