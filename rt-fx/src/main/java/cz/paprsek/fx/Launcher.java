package cz.paprsek.fx;

import java.util.logging.Level;
import java.util.logging.Logger;
import javafx.application.Application;

/** Where the process begins. Not an {@link Application} itself: Java would then look for JavaFX outside the program's own jar, and refuse to start. */
public final class Launcher {
    /** JavaFX's logger, held so that its level is not forgotten. */
    private static final Logger JAVAFX = Logger.getLogger("javafx");

    private Launcher() {}

    /** Opens the editor, with the scene file that is the first argument if there is one. */
    public static void main(String[] args) {
        // JavaFX warns of being started from one jar, which is how it is meant to be started here.
        JAVAFX.setLevel(Level.SEVERE);
        Application.launch(EditorApp.class, args);
    }
}
