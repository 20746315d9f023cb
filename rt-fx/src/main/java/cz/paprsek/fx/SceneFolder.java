package cz.paprsek.fx;

import cz.paprsek.fx.model.file.Document;
import cz.paprsek.fx.view.command.FileFinder;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.io.Failures;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import javafx.stage.Window;

/** Finds pictures, meshes and fonts in the scene's folder or below, where scenes have them; one from elsewhere can be copied there. */
record SceneFolder(Document document, Dialogs dialogs, Texts texts) implements FileFinder {

    @Override
    public Optional<String> find(Kind kind, Window owner) {
        Path scene = document.sourceProperty().get().orElseThrow(() -> new IllegalArgumentException(texts.of(kind == Kind.PICTURE ? "picture.unsaved" : "mesh.unsaved"))).file();
        Path folder = Objects.requireNonNull(scene.toAbsolutePath().getParent());
        Optional<Path> chosen = switch (kind) {
            case MESH -> dialogs.meshToOpen(Optional.of(folder));
            case PICTURE -> dialogs.pictureToOpen(folder);
            case FONT -> dialogs.fontToOpen(folder);
        };
        if (chosen.isEmpty()) {
            return Optional.empty();
        }
        try {
            Optional<String> name = document.nameOf(chosen.get());
            if (name.isEmpty() && !dialogs.isToCopy(chosen.get(), folder)) {
                throw new IllegalArgumentException(texts.of("picture.outside", chosen.get().getFileName(), folder));
            }
            return Optional.of(name.isPresent() ? name.get() : document.takeIn(chosen.get()));
        } catch (IOException unreadable) {
            throw new IllegalArgumentException(Failures.sentence(unreadable), unreadable);
        }
    }
}
