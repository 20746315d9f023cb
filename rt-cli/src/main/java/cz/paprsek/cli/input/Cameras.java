package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.scene.Scene;
import java.util.Optional;

/** The word that says which camera of a scene takes its picture. */
public final class Cameras {
    /** What {@code --help} says of it. */
    public static final String HELP = "Which of the scene's cameras: its name, or its number from 1. Default: the first.";

    private Cameras() {}

    /**
     * The scene as that camera sees it.
     *
     * @throws WrongUsage if it has no such camera, with those there are
     */
    public static Scene through(Scene scene, Optional<String> camera) {
        try {
            return camera.isEmpty() ? scene : scene.through(camera.get());
        } catch (IllegalArgumentException none) {
            throw new WrongUsage(String.valueOf(none.getMessage()));
        }
    }
}
