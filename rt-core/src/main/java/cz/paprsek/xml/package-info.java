/**
 * The scene file: reading, with every problem told by line and column, and writing. {@link cz.paprsek.xml.SceneFiles} is the only door; the rooms
 * behind it are for nobody else.
 */
@NullMarked
package cz.paprsek.xml;

import org.jspecify.annotations.NullMarked;
