/** Films: pictures one after the other, in one file. */
package cz.paprsek.image.film;
