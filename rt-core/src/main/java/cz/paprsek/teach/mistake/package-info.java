/** What goes wrong in ray tracers, one by one and together: names, lines, words. */
package cz.paprsek.teach.mistake;
