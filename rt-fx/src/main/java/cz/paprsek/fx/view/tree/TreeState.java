package cz.paprsek.fx.view.tree;

import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.scene.ScenePath;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** What goes on in the tree for now: where something would be dropped, and what is being renamed. */
final class TreeState {
    private final ReadOnlyObjectWrapper<Optional<Drop>> drop = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final ReadOnlyObjectWrapper<Optional<ScenePath>> renamed = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final Edits edits;
    private final Runnable done;

    /** @param done is run when renaming has ended */
    TreeState(Edits edits, Runnable done) {
        this.edits = edits;
        this.done = done;
    }

    ReadOnlyObjectProperty<Optional<Drop>> dropProperty() {
        return drop.getReadOnlyProperty();
    }

    ReadOnlyObjectProperty<Optional<ScenePath>> renamedProperty() {
        return renamed.getReadOnlyProperty();
    }

    void setDrop(Optional<Drop> place) {
        drop.set(place);
    }

    /** Begins to rename an item. */
    void rename(ScenePath item) {
        renamed.set(Optional.of(item));
    }

    /** Ends renaming; an unchanged name is no step. */
    void endRename(Optional<String> name) {
        Optional<ScenePath> item = renamed.get();
        renamed.set(Optional.empty());
        item.ifPresent(known -> name.ifPresent(text -> edits.rename(known, text)));
        if (item.isPresent()) {
            done.run();
        }
    }
}
