/** Tables as text. */
@NullMarked
package cz.paprsek.query.text;

import org.jspecify.annotations.NullMarked;
