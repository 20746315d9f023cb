/** Solids cut open, in the projections. */
@NullMarked
package cz.paprsek.fx.view.section;

import org.jspecify.annotations.NullMarked;
