/**
 * What files of other programs have in common, whatever their format: triangles and what they are made of, text and bytes to read, and how a fault is said.
 * Everything here believes nothing that a file claims.
 */
@NullMarked
package cz.paprsek.format.model;

import org.jspecify.annotations.NullMarked;
