package cz.paprsek.fx.model.file;

import cz.paprsek.math.Require;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.xml.DatabaseFile;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.SceneFile;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;

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

    /** A scene where it is kept, and its text there. */
    public record Kept(SceneSource source, Scene scene, KeptText text) {}

    /**
     * Reads the scene.
     *
     * @throws SceneFileException if the file is not valid
     * @throws IOException if it cannot be read
     */
    public Kept read() throws IOException, SceneFileException {
        if (inDatabase.isEmpty()) {
            SceneFile opened = SceneFiles.open(file);
            return new Kept(this, opened.scene(), KeptText.of(opened));
        }
        DatabaseFile database = DatabaseFile.open(file);
        return database.database().find(inDatabase.get()).map(scene -> new Kept(this, scene, KeptText.of(database)))
                .orElseThrow(() -> new IOException(file + ": there is no scene named \"" + inDatabase.get() + "\" any more"));
    }

    /**
     * Writes the scene; in a database it takes the place of the one that was read, and the others stay. What has not changed keeps its text.
     *
     * @param known the scene as it was read from there; if the file has another one now, nothing is written. Empty for whatever there is
     * @param text that it was read with, there or elsewhere
     * @return where it is now: in a database, under its own name
     * @throws SceneFileException if the file is no longer valid
     * @throws IOException if the file cannot be written
     */
    public Kept write(Scene scene, Optional<Scene> known, KeptText text) throws IOException, SceneFileException {
        if (inDatabase.isEmpty()) {
            return new Kept(this, scene, KeptText.of(writeFile(scene, known, text)));
        }
        Scene named = scene.name().isEmpty() ? scene.withName(inDatabase.get()) : scene;
        UnaryOperator<SceneDatabase> change = database -> {
            Optional<Scene> there = database.find(inDatabase.get());
            Require.that(there.isEmpty() || known.isEmpty() || there.equals(known) || there.get().equals(named),
                    "somebody else has changed the scene \"" + inDatabase.get() + "\" since it was read; nothing is written");
            return there.isPresent() ? database.replace(inDatabase.get(), named) : database.plus(named);
        };
        Optional<DatabaseFile> before = text.database().filter(database -> database.path().equals(file));
        OriginalText[] from = text.typed().map(typed -> typed.alone(named)).or(() -> text.file().map(SceneFile::text)).stream().toArray(OriginalText[]::new);
        DatabaseFile written = before.isPresent() ? before.get().update(change, from) : DatabaseFile.update(file, change, from);
        return new Kept(inDatabase(file, named.name()), named, KeptText.of(written));
    }

    private SceneFile writeFile(Scene scene, Optional<Scene> known, KeptText text) throws IOException, SceneFileException {
        if (text.file().isPresent()) {
            SceneFile before = text.file().get();
            return known.isPresent() && before.path().equals(file) ? before.save(scene) : before.saveAs(scene, file);
        }
        if (text.typed().isPresent()) {
            return SceneFile.of(file, text.typed().get()).saveAs(scene, file);
        }
        return text.database().isPresent() ? SceneFile.create(file, scene, text.database().get().text()) : SceneFile.create(file, scene);
    }

    /** Whether something is kept in the same folder. */
    boolean isBeside(SceneSource other) {
        return Objects.equals(file.toAbsolutePath().normalize().getParent(), other.file.toAbsolutePath().normalize().getParent());
    }

    /** For titles: "lens.xml", or "database.xml · lens". */
    public String title() {
        return file.getFileName() + inDatabase.map(name -> " · " + name).orElse("");
    }
}
