/** The scene as text beside the views. */
@NullMarked
package cz.paprsek.fx.view.xml;

import org.jspecify.annotations.NullMarked;
