/** Scenes as the text of a file, in a form of its own. */
package cz.paprsek.xml.write;
