/** Lessons: files with text, questions that are marked, and tasks that are checked on a scene. */
package cz.paprsek.lesson;
