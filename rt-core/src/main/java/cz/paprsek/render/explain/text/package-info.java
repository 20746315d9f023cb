/** Explanations in words: the tree of rays as worked exercises in two languages, as lines of text, and as JSON. Computes no light. */
@NullMarked
package cz.paprsek.render.explain.text;

import org.jspecify.annotations.NullMarked;
