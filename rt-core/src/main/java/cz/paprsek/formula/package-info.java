/** Formulas as people type them: sums, functions and names, without loops; what they are made of, and what they come to. Knows nothing of scenes. */
package cz.paprsek.formula;
