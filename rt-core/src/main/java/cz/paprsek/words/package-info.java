/** The one table of words that people read, in every language: what shapes, faces, attributes and the parts of explanations are called. */
@NullMarked
package cz.paprsek.words;

import org.jspecify.annotations.NullMarked;
