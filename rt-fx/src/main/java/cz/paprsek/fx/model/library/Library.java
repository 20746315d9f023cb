package cz.paprsek.fx.model.library;

import cz.paprsek.fx.model.History;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.edit.Names;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.xml.DatabaseFile;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** The scene database that is open: its scenes, its file, and what can be undone. For JavaFX's thread only. */
public final class Library {
    private final ReadOnlyObjectWrapper<SceneDatabase> database = new ReadOnlyObjectWrapper<>(SceneDatabase.EMPTY);
    private final ReadOnlyObjectWrapper<Optional<DatabaseFile>> file = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final ReadOnlyBooleanWrapper unsaved = new ReadOnlyBooleanWrapper();
    /** What others have changed since a step stays when it is undone. */
    private final History<SceneDatabase> history = new History<>((now, from, to) -> now.equals(from) ? to : to.rebase(from, now));

    public SceneDatabase database() {
        return database.get();
    }

    public ReadOnlyObjectProperty<SceneDatabase> databaseProperty() {
        return database.getReadOnlyProperty();
    }

    /** The file as it was read or written last; empty if none is open. */
    public Optional<DatabaseFile> file() {
        return file.get();
    }

    public ReadOnlyObjectProperty<Optional<DatabaseFile>> fileProperty() {
        return file.getReadOnlyProperty();
    }

    /** The path of the file; empty if none is open. */
    public Optional<Path> path() {
        return file().map(open -> open.path().toAbsolutePath());
    }

    /** Whether there is what the file does not have yet. */
    public ReadOnlyBooleanProperty unsavedProperty() {
        return unsaved.getReadOnlyProperty();
    }

    public ReadOnlyObjectProperty<Optional<Label>> undoableProperty() {
        return history.undoableProperty();
    }

    public ReadOnlyObjectProperty<Optional<Label>> redoableProperty() {
        return history.redoableProperty();
    }

    /** Takes a database that was read, or that is to be a new file; what could be undone is forgotten. */
    public void open(DatabaseFile opened) {
        history.clear();
        file.set(Optional.of(opened));
        show(opened.database());
    }

    /**
     * Changes the database, as one step.
     *
     * @throws IllegalArgumentException with what is wrong; nothing is changed then
     */
    public void edit(Label label, UnaryOperator<SceneDatabase> change) {
        SceneDatabase before = database();
        SceneDatabase after = change.apply(before);
        if (!after.equals(before)) {
            history.did(label, before, after);
            show(after);
        }
    }

    /**
     * Undoes the last step; what others have changed since stays.
     *
     * @throws IllegalArgumentException if others have changed the same scenes since
     */
    public void undo() {
        history.undo(database()).ifPresent(this::show);
    }

    /** As {@link #undo}, the other way. */
    public void redo() {
        history.redo(database()).ifPresent(this::show);
    }

    /** Adds a scene at the end, by its own name or one like it that is free; returns that name. */
    public String add(Scene scene) {
        String name = Names.free(scene.name().isEmpty() ? "Scene" : scene.name(), database().names());
        edit(Label.of(Edit.ADD, name), before -> before.plus(scene.withName(name)));
        return name;
    }

    /** Adds copies of scenes, as one step; returns their names. */
    public List<String> duplicate(Collection<String> names) {
        SceneDatabase before = database();
        SceneDatabase after = before;
        for (String name : names) {
            after = after.plus(before.get(name).withName(Names.free(name, after.names())));
        }
        SceneDatabase all = after;
        edit(label(Edit.DUPLICATE, names), old -> all);
        return all.names().stream().skip(before.size()).toList();
    }

    /** @throws IllegalArgumentException if the new name is none, or taken */
    public void rename(String name, String newName) {
        edit(Label.of(Edit.RENAME, name), before -> before.rename(name, newName.strip()));
    }

    /** Changes scenes, each by itself, as one step. */
    public void editEach(Collection<String> names, UnaryOperator<Scene> change) {
        edit(label(Edit.CHANGE, names), before -> {
            SceneDatabase after = before;
            for (String name : names) {
                after = after.replace(name, change.apply(after.get(name)));
            }
            return after;
        });
    }

    /** Gives scenes tags in place of those they have: words with blanks between. */
    public void tag(Collection<String> names, String words) {
        List<String> tags = words.isBlank() ? List.of() : List.of(words.strip().split("\\s+", -1));
        editEach(names, scene -> scene.withTags(tags));
    }

    public void delete(Collection<String> names) {
        edit(label(Edit.DELETE, names), before -> before.without(names));
    }

    /**
     * Takes note of what the file holds now: what others have changed in it comes in, what was changed here since stays.
     *
     * @param content what was to be written; there may have been edits since
     * @throws IllegalArgumentException if these meet changes of others in one scene; they stay unsaved
     */
    public void saved(SceneDatabase content, DatabaseFile written) {
        SceneDatabase now = written.database();
        SceneDatabase together = now.equals(content) ? database() : database().equals(content) ? now : database().rebase(content, now);
        file.set(Optional.of(written));
        show(together);
    }

    private static Label label(Edit edit, Collection<String> names) {
        return Label.of(edit, String.join(", ", names));
    }

    private void show(SceneDatabase next) {
        history.tell();
        unsaved.set(file().isPresent() && !next.equals(file().get().database()));
        if (!next.equals(database())) {
            database.set(next);
        }
    }
}
