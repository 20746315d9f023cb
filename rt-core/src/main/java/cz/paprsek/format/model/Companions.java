package cz.paprsek.format.model;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.ByteBuffer;

/** The files beside one that is read: its materials, its buffers. Names are relative; who is asked decides what they may reach. */
@FunctionalInterface
public interface Companions {
    /** There are none. */
    Companions NONE = name -> {
        throw new FileNotFoundException(FormatFault.quoted(name) + ": there are no files beside this one");
    };

    /** @throws IOException in one sentence that begins with the name, if it cannot be read */
    ByteBuffer bytes(String name) throws IOException;

    /** The name of a picture as it is found: as it is written, or, since models come from other machines, by its last part if that lies beside the model and the other is not there. */
    default String picture(String name) {
        String last = name.substring(Math.max(name.lastIndexOf('/'), name.lastIndexOf('\\')) + 1);
        return last.equals(name) || isThere(name) || !isThere(last) ? name : last;
    }

    /** Whether there is such a file. */
    default boolean isThere(String name) {
        try {
            bytes(name);
            return true;
        } catch (IOException unreadable) {
            return false;
        }
    }
}
