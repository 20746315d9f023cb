package cz.paprsek.fx.view.command;

import java.util.Optional;
import javafx.stage.Window;

/** Asks for a picture, a mesh or a font that a scene is to have. */
@FunctionalInterface
public interface FileFinder {
    /** What is looked for. */
    enum Kind { PICTURE, MESH, FONT }

    /**
     * Asks, and waits for the answer.
     *
     * @return the name by which the scene has it, relative to its folder; empty if the user thought better of it
     * @throws IllegalArgumentException with a sentence why the scene cannot have it
     */
    Optional<String> find(Kind kind, Window owner);
}
