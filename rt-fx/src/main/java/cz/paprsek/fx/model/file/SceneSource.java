package cz.paprsek.fx.model.file;

import cz.paprsek.math.Require;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.DatabaseFile;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Where a scene is kept.
 *
 * @param file a scene file or a database
 * @param inDatabase the name it has in the database; empty for a file of its own
 */
public record SceneSource(Path file, Optional<String> inDatabase) {

    /** A scene file of its own. */
    public static SceneSource file(Path file) {
        return new SceneSource(file.toAbsolutePath(), Optional.empty());
    }

    /** The scene of a name in a database. */
    public static SceneSource inDatabase(Path file, String name) {
        return new SceneSource(file.toAbsolutePath(), Optional.of(name));
    }

    /** The source that a file stands for: the only scene, or the first one of a database. */
    public static SceneSource of(Path file) throws IOException, SceneFileException {
        if (!SceneFiles.isDatabase(file)) {
            return file(file);
        }
        return SceneFiles.readDatabase(file).names().stream().findFirst().map(name -> inDatabase(file, name))
                .orElseThrow(() -> new IOException(file + ": there is no scene in this database"));
    }

    /**
     * Reads the scene.
     *
     * @throws SceneFileException if the file is not valid
     * @throws IOException if it cannot be read
     */
    public Scene read() throws IOException, SceneFileException {
        if (inDatabase.isEmpty()) {
            return SceneFiles.read(file);
        }
        return SceneFiles.readDatabase(file).find(inDatabase.get())
                .orElseThrow(() -> new IOException(file + ": there is no scene named \"" + inDatabase.get() + "\" any more"));
    }

    /**
     * Writes the scene; in a database it takes the place of the one that was read, and the others stay.
     *
     * @param known the scene as it was read from there; if a database has another one now, nothing is written. Empty for whatever there is
     * @return where it is now: in a database, under its own name
     * @throws SceneFileException if the database is no longer valid
     * @throws IOException if the file cannot be written
     */
    public SceneSource write(Scene scene, Optional<Scene> known) throws IOException, SceneFileException {
        if (inDatabase.isEmpty()) {
            SceneFiles.write(scene, file);
            return this;
        }
        Scene named = scene.name().isEmpty() ? scene.withName(inDatabase.get()) : scene;
        DatabaseFile.update(file, database -> {
            Optional<Scene> there = database.find(inDatabase.get());
            Require.that(there.isEmpty() || known.isEmpty() || there.equals(known) || there.get().equals(named),
                    "somebody else has changed the scene \"" + inDatabase.get() + "\" since it was read; nothing is written");
            return there.isPresent() ? database.replace(inDatabase.get(), named) : database.plus(named);
        });
        return inDatabase(file, named.name());
    }

    /** For titles: "lens.xml", or "database.xml · lens". */
    public String title() {
        return file.getFileName() + inDatabase.map(name -> " · " + name).orElse("");
    }
}
