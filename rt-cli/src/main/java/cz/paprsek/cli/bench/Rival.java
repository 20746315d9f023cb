package cz.paprsek.cli.bench;

import cz.paprsek.scene.Scene;
import java.io.IOException;

/** Whom to compare with: renders the same scenes in turn with us. */
interface Rival extends AutoCloseable {
    /** How it is called above its column, eight letters at most. */
    String label();

    /** Which it is: name and number. */
    String version();

    /** Whether its first renders are slow, as ours are, and do not count. */
    boolean warmsUp();

    /**
     * Renders a scene once.
     *
     * @param name of the scene among the standard ones
     * @return processor time, in seconds
     */
    double seconds(String name, Scene scene, int threads) throws IOException;

    /** Ends what it has started. */
    @Override
    default void close() throws IOException {}
}
