/** Text of scene files while it is being written, when it need not be well-formed: what in it is what, and what could stand at a place. Knows the schema. */
@NullMarked
package cz.paprsek.xml.typing;

import org.jspecify.annotations.NullMarked;
