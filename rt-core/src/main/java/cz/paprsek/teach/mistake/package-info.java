/** What goes wrong in ray tracers, one by one and together: names, lines, words. */
@NullMarked
package cz.paprsek.teach.mistake;

import org.jspecify.annotations.NullMarked;
