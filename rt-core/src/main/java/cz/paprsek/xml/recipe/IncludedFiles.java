package cz.paprsek.xml.recipe;

import java.io.IOException;
import java.util.Optional;

/** Files that scenes include, by their names relative to the scene's folder. */
@FunctionalInterface
public interface IncludedFiles {
    /**
     * The content of one, well-formed XML in UTF-8.
     *
     * @throws IOException with one sentence that says why it cannot be had
     */
    byte[] read(String name) throws IOException;

    /** What messages call one; empty if it is called as it is seen from the file that includes it. */
    default Optional<String> called(String name) {
        return Optional.empty();
    }
}
