package cz.paprsek.xml;

/**
 * One thing that is wrong with a file.
 *
 * @param file the file's name as the caller gave it
 * @param line where, from 1
 * @param column where, from 1
 * @param message what was expected and what was found, in one line
 */
public record Problem(String file, int line, int column, String message) {
    @Override
    public String toString() {
        return file + ":" + line + ":" + column + ": " + message;
    }
}
