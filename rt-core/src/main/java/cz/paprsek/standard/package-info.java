/** Scenes to measure with. Not offered to everybody: they may change with what is to be measured. */
@NullMarked
package cz.paprsek.standard;

import org.jspecify.annotations.NullMarked;
