/** Pages of text and lines as PDF, with the fonts that they need in them. */
package cz.paprsek.sheet.pdf;
