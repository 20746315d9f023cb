/** Pages of text and lines as PDF, with the fonts that they need in them. */
@NullMarked
package cz.paprsek.sheet.pdf;

import org.jspecify.annotations.NullMarked;
