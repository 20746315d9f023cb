package cz.paprsek.xml.format;

import cz.paprsek.scene.Scene;
import java.util.List;

/** What a reader found in a file: one scene, or those of a database. */
public record FileScenes(List<Scene> scenes, boolean isDatabase) {
    public FileScenes {
        scenes = List.copyOf(scenes);
    }
}
