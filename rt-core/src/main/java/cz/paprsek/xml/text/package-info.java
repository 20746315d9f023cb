/**
 * A file's own text, changed where its content has changed and nowhere else: comments, order and wording stay. Knows elements and attributes,
 * but not what they mean: that comes in as {@link cz.paprsek.xml.text.Form}s.
 */
@NullMarked
package cz.paprsek.xml.text;

import org.jspecify.annotations.NullMarked;
