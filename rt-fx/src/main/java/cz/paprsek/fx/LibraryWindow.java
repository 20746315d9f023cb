package cz.paprsek.fx;

import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Clipboard;
import cz.paprsek.fx.model.file.Document;
import cz.paprsek.fx.model.file.SceneSource;
import cz.paprsek.fx.model.library.Library;
import cz.paprsek.fx.model.library.LibraryLink;
import cz.paprsek.fx.model.library.LibraryStore;
import cz.paprsek.fx.view.library.Desk;
import cz.paprsek.fx.view.library.LibraryPane;
import cz.paprsek.fx.view.library.Worker;
import cz.paprsek.fx.view.texts.Shortcut;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.DatabaseFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import javafx.application.Platform;
import javafx.stage.Stage;
import org.jspecify.annotations.Nullable;

/** The window of the scene database; made when it is first needed. The library itself lives as long as the editor. */
final class LibraryWindow implements Desk {
    /** The key of the settings for the database that was open last. */
    private static final String LAST = "library";

    private final Editor editor;
    private final Dialogs dialogs;
    private final Library library = new Library();
    private final ExecutorService worker = Worker.named("library-file");
    private final LibraryStore store = new LibraryStore(library, worker, Platform::runLater);
    private final LibraryLink link;
    private @Nullable Stage stage;
    private @Nullable LibraryPane pane;

    LibraryWindow(Editor editor, Document document, Dialogs dialogs) {
        this.editor = editor;
        this.dialogs = dialogs;
        this.link = new LibraryLink(library, document);
        library.fileProperty().addListener((property, old, now) -> {
            showTitle();
            remember();
        });
    }

    Library library() {
        return library;
    }

    /** The window; empty if it has not been needed yet. */
    Optional<Stage> stage() {
        return Optional.ofNullable(stage);
    }

    /** Shows the window; if no database is open, with that of the scene that is edited, or else with the last one. */
    void show() {
        Stage open = stage;
        if (open == null) {
            Stage shown = new Stage();
            open = shown;
            open.setScene(new javafx.scene.Scene(new javafx.scene.layout.StackPane(), 1160, 740));
            shown.getScene().getAccelerators().put(Shortcut.of("Shortcut+W"), shown::hide);
            open.focusedProperty().addListener((property, old, now) -> store.checkDisk());
            stage = open;
            WindowPlace.keep(open, editor.settings(), "window.library", () -> Sizes.opened(shown, 1160, 740, Optional.empty()));
            fill();
        }
        if (library.file().isEmpty()) {
            editor.document().sourceProperty().get().filter(source -> source.inDatabase().isPresent()).map(SceneSource::file)
                    .or(this::remembered).ifPresent(file -> store.open(file, editor::wrong));
        }
        open.show();
        open.toFront();
    }

    /** Takes a database that the editor has opened, and shows it. */
    void show(DatabaseFile opened) {
        store.opened(opened);
        show();
    }

    /** Makes the window's content anew, in the editor's language. */
    void fill() {
        if (stage != null) {
            if (pane != null) {
                pane.close();
            }
            pane = new LibraryPane(library, store, this, editor.texts(), dialogs.libraryFiles(editor.texts()));
            stage.getScene().setRoot(pane);
            editor.theme().get().applyTo(stage.getScene());
            showTitle();
        }
    }

    /** Takes in what others have changed in the file. */
    void checkDisk() {
        store.checkDisk();
    }

    /** Whether the library may be left: all that was changed is in its file, or the user gives it up. */
    boolean mayLeave() {
        while (!store.flush()) {
            String title = library.path().map(Path::toString).orElse("");
            switch (dialogs.aboutUnsaved(title + ": " + editor.texts().sentence(store.refusalProperty().get()))) {
                case SAVE -> store.retry();
                case DISCARD -> {
                    return true;
                }
                case STAY -> {
                    show();
                    return false;
                }
            }
        }
        return true;
    }

    void close() {
        if (pane != null) {
            pane.close();
        }
        if (stage != null) {
            stage.close();
        }
        worker.shutdown();
    }

    @Override
    public void open(String name) {
        if (store.flush()) {
            library.path().ifPresent(path -> editor.files().open(SceneSource.inDatabase(path, name), library.database().get(name)));
            editor.stage().toFront();
        }
    }

    @Override
    public void keep() {
        if (link.name().isPresent()) {
            editor.files().save();
            store.checkDisk();
            return;
        }
        Scene scene = editor.model().scene();
        String name = library.add(scene);
        if (editor.document().sourceProperty().get().isEmpty()) {
            library.path().ifPresent(path -> editor.files().kept(SceneSource.inDatabase(path, name), scene.withName(name)));
        }
    }

    @Override
    public void insert(Scene scene) {
        editor.model().editState(Label.of(Label.Edit.PASTE, scene.name()), state -> Clipboard.insert(state, scene));
    }

    private void remember() {
        library.path().map(Path::toString).filter(path -> !editor.settings().get(LAST).equals(Optional.of(path)))
                .ifPresent(path -> editor.settings().set(LAST, path));
    }

    private Optional<Path> remembered() {
        return editor.settings().get(LAST).map(Path::of).filter(Files::isRegularFile);
    }

    private void showTitle() {
        if (stage != null && pane != null) {
            stage.setTitle(pane.title() + " – Paprsek");
        }
    }
}
