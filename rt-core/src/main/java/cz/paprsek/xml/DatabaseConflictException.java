package cz.paprsek.xml;

import java.io.IOException;

/** Somebody else changed the same scene of a file meanwhile, or the same scenes of a database, which the message names. */
public final class DatabaseConflictException extends IOException {
    private static final long serialVersionUID = 1;

    DatabaseConflictException(String message) {
        super(message);
    }

    DatabaseConflictException(String message, Throwable cause) {
        super(message, cause);
    }
}
