package cz.paprsek.fx.view.explain;

import cz.paprsek.fx.view.dialog.FileBox;
import cz.paprsek.fx.view.texts.Texts;
import java.nio.file.Path;
import java.util.Optional;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import javafx.stage.Window;

/** Asks where the tree of a pixel is to be saved. */
@FunctionalInterface
public interface TreeChooser {

    /**
     * Asks, and waits for the answer.
     *
     * @param name the name to suggest, with the extension of the kind of file
     * @return empty if the user thought better of it
     */
    Optional<Path> choose(Window owner, String name);

    /** Asks in the system's own dialog. */
    static TreeChooser ofSystem(Texts texts) {
        return (owner, name) -> {
            String extension = name.substring(name.lastIndexOf('.'));
            FileChooser chooser = new FileChooser();
            chooser.setTitle(texts.of("explain.save"));
            chooser.setInitialFileName(name);
            chooser.getExtensionFilters().add(new ExtensionFilter(texts.of("explain.save" + extension), "*" + extension));
            return FileBox.toSave(chooser, owner, texts);
        };
    }
}
