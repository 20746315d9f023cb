package cz.paprsek.xml;

import java.util.Objects;

/**
 * One thing that is wrong with a file.
 *
 * @param file the file's name as the caller gave it
 * @param line where, from 1
 * @param column where, from 1
 * @param message what was expected and what was found, in one line
 */
public record Problem(String file, int line, int column, String message) {
    public Problem {
        Objects.requireNonNull(file, "file");
        Objects.requireNonNull(message, "message");
    }

    @Override
    public String toString() {
        return file + ":" + line + ":" + column + ": " + message;
    }
}
