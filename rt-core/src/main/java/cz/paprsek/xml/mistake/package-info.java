/** What is wrong with a file, and how it is said: where, what was expected, what was found. Knows parser and validator by their messages, and nothing of beans. */
@NullMarked
package cz.paprsek.xml.mistake;

import org.jspecify.annotations.NullMarked;
