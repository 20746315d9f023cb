/** The one table of words that people read, in every language: what shapes, faces, attributes and the parts of explanations are called. */
package cz.paprsek.words;
