/** What holds for scene files whoever reads or writes them: limits, the schema, the names of colours. */
@NullMarked
package cz.paprsek.xml.format;

import org.jspecify.annotations.NullMarked;
