/** What solids look like where a plane cuts them open. */
@NullMarked
package cz.paprsek.fx.model.section;

import org.jspecify.annotations.NullMarked;
