package cz.paprsek.cli.db;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.scene.SceneDatabase.Clash;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Scenes of several files in one database, and which file each is from. */
final class Gathered {
    private final Map<String, Path> origins = new HashMap<>();
    private SceneDatabase scenes;

    /** Begins with what is in a database already. */
    Gathered(Path file, SceneDatabase scenes) {
        this.scenes = scenes;
        scenes.names().forEach(name -> origins.put(name, file));
    }

    SceneDatabase scenes() {
        return scenes;
    }

    /**
     * Takes in the scenes of one more file.
     *
     * @param hint what could be done about scenes of the same name
     * @throws WrongUsage if there are different ones of the same name and that is to be refused
     */
    void add(Path file, SceneDatabase more, Clash clash, String hint) {
        List<Scene> clashing = more.scenes().stream()
                .filter(scene -> scenes.find(scene.name()).filter(there -> !there.equals(scene)).isPresent()).toList();
        if (clash == Clash.REFUSE && !clashing.isEmpty()) {
            Scene first = clashing.get(0);
            throw new WrongUsage(origins.get(first.name()) + " and " + file + " have different scenes named \"" + first.name() + "\""
                    + (clashing.size() > 1 ? ", and " + (clashing.size() - 1) + " more of the same names" : "") + "; " + hint);
        }
        more.names().stream().filter(name -> clash == Clash.REPLACE || scenes.find(name).isEmpty()).forEach(name -> origins.put(name, file));
        scenes = scenes.merge(more, clash);
    }
}
