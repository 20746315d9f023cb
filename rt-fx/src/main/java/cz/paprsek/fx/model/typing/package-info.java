/** The text of the scene, while somebody writes in it. */
@NullMarked
package cz.paprsek.fx.model.typing;

import org.jspecify.annotations.NullMarked;
