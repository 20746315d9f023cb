package cz.paprsek.fx.view.library;

import cz.paprsek.scene.Scene;

/** The editor beside the library: scenes go from one to the other. */
public interface Desk {
    /** Opens a scene of the library in the editor, unless the user stays because of what is unsaved there. */
    void open(String name);

    /** Puts the scene that is edited into the library, or what has become of it if it came from there. */
    void keep();

    /** Adds the objects, lights and materials of a scene to the one that is edited. */
    void insert(Scene scene);
}
