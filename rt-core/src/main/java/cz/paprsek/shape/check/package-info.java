/** Tries shapes that were made in code, for their makers' tests. */
package cz.paprsek.shape.check;
