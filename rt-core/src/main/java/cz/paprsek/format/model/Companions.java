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
}
