package cz.paprsek.fx.view.library;

import cz.paprsek.fx.model.library.Library;
import cz.paprsek.fx.model.library.LibraryStore;
import cz.paprsek.fx.view.texts.Texts;
import java.util.List;
import javafx.scene.control.Button;
import javafx.scene.layout.Region;
import javafx.stage.Window;

/** What buttons and keys of the library do. */
final class LibraryActions {
    private final Library library;
    private final LibraryStore store;
    private final SceneSelection selection;
    private final Desk desk;
    private final Texts texts;
    private final LibraryFiles files;
    private final LibraryMessages messages;

    LibraryActions(Library library, LibraryStore store, SceneSelection selection, Desk desk, Texts texts, LibraryFiles files,
            LibraryMessages messages) {
        this.library = library;
        this.store = store;
        this.selection = selection;
        this.desk = desk;
        this.texts = texts;
        this.files = files;
        this.messages = messages;
    }

    static Button button(Texts texts, String key, Runnable action) {
        Button button = new Button(texts.of(key));
        button.setId(key.replace('.', '-'));
        button.setMinWidth(Region.USE_PREF_SIZE);
        button.setOnAction(event -> action.run());
        return button;
    }

    void open(Window owner) {
        files.toOpen(owner).ifPresent(path -> store.open(path, messages::wrong));
    }

    void create(Window owner) {
        files.toCreate(owner).ifPresent(path -> store.create(path, messages::wrong));
    }

    void keep() {
        messages.attempt(desk::keep);
    }

    void undo() {
        messages.attempt(library::undo);
    }

    void redo() {
        messages.attempt(library::redo);
    }

    void openSelected() {
        selection.names().stream().findFirst().ifPresent(desk::open);
    }

    void insertSelected() {
        messages.attempt(() -> selection.names().forEach(name -> {
            desk.insert(library.database().get(name));
            messages.say(texts.of("library.inserted", name));
        }));
    }

    void duplicateSelected() {
        messages.attempt(() -> {
            List<String> copies = library.duplicate(selection.names());
            selection.only(copies);
        });
    }

    void deleteSelected() {
        List<String> names = selection.names();
        if (messages.attempt(() -> library.delete(names)) && !names.isEmpty()) {
            messages.say(texts.of("library.deleted", names.size()));
        }
    }
}
