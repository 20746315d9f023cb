package cz.paprsek.fx.model;

import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import java.io.IOException;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** The model's scene as something kept in a file, or not yet. For JavaFX's thread only. */
public final class Document {
    private final EditorModel model;
    private final ReadOnlyObjectWrapper<Optional<SceneSource>> source = new ReadOnlyObjectWrapper<>(Optional.empty());
    private Optional<FileStamp> stamp = Optional.empty();

    public Document(EditorModel model) {
        this.model = model;
    }

    public EditorModel model() {
        return model;
    }

    /** Where the scene is kept; empty if it has never been saved. */
    public ReadOnlyObjectProperty<Optional<SceneSource>> sourceProperty() {
        return source.getReadOnlyProperty();
    }

    /** Takes a scene that was read from a source. */
    public void opened(SceneSource from, Scene scene) {
        source.set(Optional.of(from));
        stamp = FileStamp.of(from.file());
        model.open(scene);
    }

    /** Takes a scene that is in no file. */
    public void openedWithoutFile(Scene scene) {
        source.set(Optional.empty());
        stamp = Optional.empty();
        model.open(scene);
    }

    /** Takes a scene that was to be saved at a source, or at none, and was not. */
    public void recovered(Optional<SceneSource> from, Scene scene) {
        source.set(from);
        stamp = from.flatMap(known -> FileStamp.of(known.file()));
        model.openUnsaved(scene);
    }

    /**
     * Saves the scene where it is kept from now on.
     *
     * @throws IOException if it cannot be written; the old file is still there
     * @throws SceneFileException if it is to go into a database that is not valid
     * @throws IllegalArgumentException if the scene has what no file can hold
     */
    public void save(SceneSource to) throws IOException, SceneFileException {
        Scene scene = model.scene();
        source.set(Optional.of(to.write(scene)));
        stamp = FileStamp.of(to.file());
        model.saved(scene);
    }

    /** Whether the file is there, and another one than was read or written last. Says so once: after {@link #noticeDisk} it counts as known. */
    public boolean hasChangedOnDisk() {
        Optional<FileStamp> now = source.get().flatMap(known -> FileStamp.of(known.file()));
        return now.isPresent() && !now.equals(stamp);
    }

    /** Takes note of the file as it is on disk now. */
    public void noticeDisk() {
        stamp = source.get().flatMap(known -> FileStamp.of(known.file()));
    }

    /** Takes the scene as it is on disk now in the place of this one, as a step that can be undone. */
    public void reloaded(Label label, Scene scene) {
        noticeDisk();
        model.reload(label, scene);
    }
}
