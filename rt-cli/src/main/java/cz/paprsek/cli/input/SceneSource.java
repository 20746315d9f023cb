package cz.paprsek.cli.input;

import cz.paprsek.query.Filter;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Where a scene comes from: a file of its own, or a database.
 *
 * @param label how to call it in a message
 * @param name what {@code {name}} stands for
 * @param known the scene, if it has been read already
 */
public record SceneSource(Path file, String label, String name, Optional<Scene> known) {

    /** A file that is read when its turn comes. */
    public static SceneSource of(Path file) {
        return new SceneSource(file, file.toString(), SceneArguments.nameOf(file), Optional.empty());
    }

    /**
     * The scenes of files and databases that match a filter. Only databases are read at once, and all files if there is a filter; a file that
     * cannot be read stays in the list, to be complained of when its turn comes.
     */
    public static List<SceneSource> all(List<Path> files, Optional<Filter<Scene>> filter) {
        List<SceneSource> sources = new ArrayList<>();
        for (Path file : files) {
            boolean isDatabase = isDatabase(file);
            SceneReading reading = isDatabase || filter.isPresent() ? SceneReading.of(file) : new SceneReading(file, List.of(), List.of());
            if (reading.scenes().isEmpty() && !(isDatabase && reading.isValid())) {
                sources.add(of(file));
            }
            Map<String, String> names = FileNames.of(reading.scenes().stream().map(Scene::name).toList());
            for (int i = 0; i < reading.scenes().size(); i++) {
                Scene scene = reading.scenes().get(i);
                if (filter.isEmpty() || filter.get().test(scene)) {
                    sources.add(isDatabase ? new SceneSource(file, file + ": scene \"" + scene.name() + "\"", names.getOrDefault(scene.name(), ""), Optional.of(scene))
                            : new SceneSource(file, file.toString(), SceneArguments.nameOf(file), Optional.of(scene)));
                }
            }
        }
        return sources;
    }

    private static boolean isDatabase(Path file) {
        try {
            return Foreign.kind(file).isEmpty() && SceneFiles.isDatabase(file);
        } catch (IOException unreadable) {
            // Whoever reads it will say so.
            return false;
        }
    }

    public Scene read() throws SceneFileException, IOException {
        if (known.isPresent()) {
            return known.get();
        }
        Foreign.refuse(file);
        return SceneFiles.read(file);
    }
}
