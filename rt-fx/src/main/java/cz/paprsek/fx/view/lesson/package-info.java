/** Lessons beside the views: what is told, asked and to be done, and how far one has got. */
package cz.paprsek.fx.view.lesson;
