/** Formulas as people type them: sums, functions and names, without loops; what they are made of, and what they come to. Knows nothing of scenes. */
@NullMarked
package cz.paprsek.formula;

import org.jspecify.annotations.NullMarked;
