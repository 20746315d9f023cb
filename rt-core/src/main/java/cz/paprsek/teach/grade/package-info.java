/** Says what is wrong with a picture: which mistakes of the plain tracer's give the same. */
@NullMarked
package cz.paprsek.teach.grade;

import org.jspecify.annotations.NullMarked;
