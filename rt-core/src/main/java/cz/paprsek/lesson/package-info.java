/** Lessons: files with text, questions that are marked, and tasks that are checked on a scene. */
@NullMarked
package cz.paprsek.lesson;

import org.jspecify.annotations.NullMarked;
