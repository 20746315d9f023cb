package cz.paprsek.xml.mistake;

import java.util.List;

/**
 * Something that is wrong with a file.
 *
 * @param line where, from 1
 * @param column where, from 1
 * @param message what was expected and what was found, in one line
 * @param attributes which attribute of the element there is at fault: the first of these that it has; none if that is none or several
 */
public record Mistake(int line, int column, String message, List<String> attributes) {
    public Mistake {
        attributes = List.copyOf(attributes);
    }
}
