/** What light falls on. */
package cz.paprsek.render.film;
