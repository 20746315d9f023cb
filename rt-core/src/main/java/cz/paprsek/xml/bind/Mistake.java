package cz.paprsek.xml.bind;

/**
 * Something that is wrong with a file.
 *
 * @param line where, from 1
 * @param column where, from 1
 * @param message what was expected and what was found, in one line
 */
public record Mistake(int line, int column, String message) {}
