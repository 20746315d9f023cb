package cz.paprsek.xml;

import java.io.IOException;

/** Somebody else changed the same scenes of a database file meanwhile; the message names them. */
public final class DatabaseConflictException extends IOException {
    private static final long serialVersionUID = 1;

    DatabaseConflictException(String message, Throwable cause) {
        super(message, cause);
    }
}
