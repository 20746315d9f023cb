/** What is kept of a picture that may be interrupted, and by what it is known again. */
@NullMarked
package cz.paprsek.resume;

import org.jspecify.annotations.NullMarked;
