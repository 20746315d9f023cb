package cz.paprsek.cli.input;

import cz.paprsek.format.ForeignFormat;
import cz.paprsek.format.ForeignScene;
import cz.paprsek.query.Filter;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import cz.paprsek.xml.SceneFiles.Contents;
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
 * @param reading reads the scene, or hands out what has been read already
 */
public record SceneSource(Path file, String label, String name, Reading reading) {

    /** How to come by a scene. */
    public interface Reading {
        Scene read() throws SceneFileException, IOException;

        /** What was met in the file but not taken along, after it has been read. */
        default List<String> notes() {
            return List.of();
        }
    }

    /** A file that is read when its turn comes; one of another program with a floor, or without. */
    public static SceneSource of(Path file, boolean hasFloor) {
        return of(file, hasFloor, ParameterWishes.NONE);
    }

    /** As {@link #of(Path, boolean)}, with other values of parameters. */
    public static SceneSource of(Path file, boolean hasFloor, ParameterWishes parameters) {
        Optional<ForeignFormat> format = Models.format(file);
        format.ifPresent(foreign -> Incoming.refuse(file, parameters));
        return new SceneSource(file, file.toString(), Incoming.nameOf(file),
                format.isPresent() ? new ModelReading(file, format.get(), hasFloor) : () -> Incoming.scene(file, parameters));
    }

    /** A file of another program, read once. */
    private static final class ModelReading implements Reading {
        private final Path file;
        private final ForeignFormat format;
        private final boolean hasFloor;
        /** What has been read ahead, until it is asked for. */
        private Optional<ForeignScene> ahead = Optional.empty();
        private List<String> notes = List.of();

        ModelReading(Path file, ForeignFormat format, boolean hasFloor) {
            this.file = file;
            this.format = format;
            this.hasFloor = hasFloor;
        }

        private ForeignScene model() throws IOException {
            ForeignScene model = Models.read(file, format);
            return hasFloor ? model : model.withoutFloor();
        }

        Scene readAhead() throws IOException {
            ahead = Optional.of(model());
            return ahead.get().scene();
        }

        @Override
        public Scene read() throws IOException {
            ForeignScene model = ahead.isPresent() ? ahead.get() : model();
            ahead = Optional.empty();
            notes = model.notes();
            return model.scene();
        }

        @Override
        public List<String> notes() {
            return notes;
        }
    }

    /**
     * The scenes of files and databases that match a filter. Only databases are read at once, what can be read once, and all files if there is a
     * filter; what cannot be read stays in the list, to be complained of when its turn comes.
     *
     * @param haveFloors whether files of other programs get the floor that they have not themselves
     */
    public static List<SceneSource> all(List<Path> files, Optional<Filter<Scene>> filter, boolean haveFloors, ParameterWishes parameters) {
        List<SceneSource> sources = new ArrayList<>();
        for (Path file : files) {
            SceneSource source = of(file, haveFloors, parameters);
            if (source.reading instanceof ModelReading model) {
                if (filter.isEmpty() || isWanted(model, filter.get())) {
                    sources.add(source);
                }
            } else if (filter.isPresent() || Incoming.isOnce(file) || isDatabase(file)) {
                sources.addAll(read(file, filter, parameters));
            } else {
                sources.add(source);
            }
        }
        return sources;
    }

    private static boolean isWanted(ModelReading model, Filter<Scene> filter) {
        try {
            return filter.test(model.readAhead());
        } catch (IOException unreadable) {
            // Whoever reads it will say why.
            return true;
        }
    }

    private static List<SceneSource> read(Path file, Optional<Filter<Scene>> filter, ParameterWishes parameters) {
        try {
            boolean isGivenLater = filter.isPresent() && ChosenValues.areFor(file, parameters);
            Contents contents = Incoming.read(file, isGivenLater ? parameters.withoutValues() : parameters);
            Map<String, String> names = FileNames.of(contents.scenes().stream().map(Scene::name).toList());
            List<Scene> chosen = contents.scenes().stream().filter(scene -> filter.isEmpty() || filter.get().test(scene)).toList();
            return (isGivenLater ? ChosenValues.given(file, chosen, parameters.values()) : chosen).stream().map(scene -> {
                String own = names.getOrDefault(scene.name(), "");
                return contents.isDatabase() ? new SceneSource(file, file + ": scene \"" + scene.name() + "\"", own, () -> scene)
                        : new SceneSource(file, file.toString(), Incoming.isOnce(file) ? own : Incoming.nameOf(file), () -> scene);
            }).toList();
        } catch (SceneFileException wrong) {
            return List.of(new SceneSource(file, file.toString(), Incoming.nameOf(file), () -> {
                throw wrong;
            }));
        } catch (IOException unreadable) {
            return List.of(new SceneSource(file, file.toString(), Incoming.nameOf(file), () -> {
                throw unreadable;
            }));
        }
    }

    private static boolean isDatabase(Path file) {
        try {
            return Models.format(file).isEmpty() && Foreign.kind(file).isEmpty() && SceneFiles.isDatabase(file);
        } catch (IOException unreadable) {
            // Whoever reads it will say so.
            return false;
        }
    }

    public Scene read() throws SceneFileException, IOException {
        return reading.read();
    }
}
