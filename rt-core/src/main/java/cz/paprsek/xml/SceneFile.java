package cz.paprsek.xml;

import cz.paprsek.io.FileLock;
import cz.paprsek.math.Require;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * A scene and the text of the file that it was read from. What is saved is that text, changed where the scene has changed: comments, order,
 * wording, encoding and every other byte stay. A scene that is changed back gives the old bytes back. Immutable.
 */
public final class SceneFile {
    private final Path path;
    private final Scene scene;
    /** The file as it was opened, which later saves start from, too. */
    private final OriginalText text;
    /** Of the file as it was read or written last. */
    private final byte[] digest;

    private SceneFile(Path path, Scene scene, OriginalText text, byte[] digest) {
        this.path = path;
        this.scene = scene;
        this.text = text;
        this.digest = digest;
    }

    static SceneFile open(Path path, ReadMonitor monitor) throws SceneFileException, IOException {
        OriginalText text = OriginalText.read(path, monitor);
        return new SceneFile(path, SceneFiles.only(text.contents(), path.toString()), text, DatabaseFile.newDigest().digest(text.bytes()));
    }

    /**
     * Writes a scene into a new file, or over an old one whatever that holds.
     *
     * @throws IOException if it cannot be written
     * @throws IllegalArgumentException as {@link SceneFiles#format}
     */
    public static SceneFile create(Path path, Scene scene) throws IOException {
        OriginalText text = OriginalText.of(scene);
        SceneFiles.write(path, text.bytes());
        return new SceneFile(path, scene, text, DatabaseFile.newDigest().digest(text.bytes()));
    }

    /**
     * As {@link #create(Path, Scene)}, for a scene that comes from another file, with the text that it has there.
     *
     * @throws IOException if it cannot be written
     * @throws IllegalArgumentException as {@link SceneFiles#format}
     */
    public static SceneFile create(Path path, Scene scene, OriginalText from) throws IOException {
        OriginalText text = from.alone(scene);
        SceneFiles.write(path, text.bytes());
        return new SceneFile(path, scene, text, DatabaseFile.newDigest().digest(text.bytes()));
    }

    /**
     * A file that is not there yet, for a scene that has a text.
     *
     * @throws IllegalArgumentException if that is not the text of one scene
     */
    public static SceneFile of(Path path, OriginalText text) {
        Objects.requireNonNull(path, "path");
        Require.that(text.contents().scenes().size() == 1, "a file of its own needs the text of one scene");
        return new SceneFile(path, text.contents().scenes().get(0), text, new byte[0]);
    }

    /** The same file, to be saved with another text than it was opened with. */
    public SceneFile withText(OriginalText typed) {
        return new SceneFile(path, scene, Objects.requireNonNull(typed, "typed"), digest);
    }

    /** Whether both had the same bytes when they were read or written last. */
    public boolean isAs(SceneFile other) {
        return Arrays.equals(digest, other.digest);
    }

    public Path path() {
        return path;
    }

    /** The scene that is in the file. */
    public Scene scene() {
        return scene;
    }

    /** The file as it was opened, to take the scene from it into other files. */
    public OriginalText text() {
        return text;
    }

    /**
     * Writes what the scene has become; the file is replaced as a whole or not at all. If others have changed the text meanwhile, but not the
     * scene, it is theirs that is changed; not if there is a text that was typed here.
     *
     * @return the file as it is now
     * @throws DatabaseConflictException if others have changed the scene in the file since, or anything in it and a text was typed here; nothing is written
     * @throws SceneFileException if others left the file so that it cannot be read; nothing is written
     * @throws IOException if it cannot be written
     * @throws IllegalArgumentException as {@link SceneFiles#format}
     */
    @SuppressWarnings("try") // The lock is held, not used.
    public SceneFile save(Scene changed) throws SceneFileException, IOException {
        Objects.requireNonNull(changed, "changed");
        DatabaseFile.requireFile(path);
        try (FileLock lock = FileLock.of(path, DatabaseFile.PATIENCE_MILLIS)) {
            if (!Files.exists(path) || Arrays.equals(DatabaseFile.digest(path), digest)) {
                return saveAs(changed, path);
            }
            SceneFile theirs = open(path, ReadMonitor.NONE);
            // What somebody has typed cannot be woven into what others have.
            if (text.isTyped() || !theirs.scene.equals(scene)) {
                throw new DatabaseConflictException(path + ": somebody else has changed this file since it was read; nothing is written");
            }
            return theirs.saveAs(changed, path);
        }
    }

    /**
     * Writes what the scene has become into another file, whatever that holds.
     *
     * @return that file
     * @throws IOException if it cannot be written
     * @throws IllegalArgumentException as {@link SceneFiles#format}
     */
    public SceneFile saveAs(Scene changed, Path elsewhere) throws IOException {
        Objects.requireNonNull(changed, "changed");
        Objects.requireNonNull(elsewhere, "elsewhere");
        byte[] bytes = text.with(List.of(changed), List.of());
        SceneFiles.write(elsewhere, bytes);
        return new SceneFile(elsewhere, changed, text, DatabaseFile.newDigest().digest(bytes));
    }
}
