/** OpenEXR files as bytes and named planes of numbers; knows nothing of light. */
@NullMarked
package cz.paprsek.image.exr;

import org.jspecify.annotations.NullMarked;
