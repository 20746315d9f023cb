/** Reads good files, and those of the common kind only, in no time: straight into records, by what stands at their components. */
@NullMarked
package cz.paprsek.xml.quick;

import org.jspecify.annotations.NullMarked;
