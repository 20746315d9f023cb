/** Says what is wrong with a picture: which mistakes of the plain tracer's give the same. */
package cz.paprsek.teach.grade;
