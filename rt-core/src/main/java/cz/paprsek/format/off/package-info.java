/** OFF, the Object File Format of Geomview, in text. No unit; axes as they are. */
@NullMarked
package cz.paprsek.format.off;

import org.jspecify.annotations.NullMarked;
