/** Scenes as the text of a file, in a form of its own. */
@NullMarked
package cz.paprsek.xml.write;

import org.jspecify.annotations.NullMarked;
