/** PNG files as bytes and samples; knows nothing of light. */
@NullMarked
package cz.paprsek.image.png;

import org.jspecify.annotations.NullMarked;
