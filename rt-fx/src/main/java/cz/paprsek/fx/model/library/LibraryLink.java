package cz.paprsek.fx.model.library;

import cz.paprsek.fx.model.file.Document;
import cz.paprsek.fx.model.file.SceneSource;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import java.util.Optional;

/**
 * Keeps the scene that is edited in step with the library it came from: what it is called, its tags and its description. What else becomes of
 * it in the library counts as a change on disk.
 */
public final class LibraryLink {
    private final Library library;
    private final Document document;

    public LibraryLink(Library library, Document document) {
        this.library = library;
        this.document = document;
        library.databaseProperty().addListener((property, before, now) -> name().ifPresent(name -> follow(name, before, now)));
    }

    /** The name in the library of the scene that is edited; empty if it is not from there. */
    public Optional<String> name() {
        return document.sourceProperty().get().filter(source -> Optional.of(source.file()).equals(library.path())).flatMap(SceneSource::inDatabase);
    }

    private void follow(String name, SceneDatabase before, SceneDatabase now) {
        before.find(name).ifPresent(old -> now.find(name).or(() -> renamed(old, before, now)).filter(fresh -> !fresh.equals(old))
                .ifPresent(fresh -> document.relabelled(SceneSource.inDatabase(library.path().orElseThrow(), fresh.name()), old, fresh)));
    }

    /** The scene that is new under another name, and the same otherwise. */
    private static Optional<Scene> renamed(Scene old, SceneDatabase before, SceneDatabase now) {
        return now.scenes().stream().filter(scene -> before.find(scene.name()).isEmpty() && scene.withName(old.name()).equals(old)).findFirst();
    }
}
