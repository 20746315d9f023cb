package cz.paprsek.fx.view.picture;

import cz.paprsek.fx.view.dialog.FileBox;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.ImageFormat;
import java.nio.file.Path;
import java.util.Optional;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import javafx.stage.Window;

/** Asks where a picture is to be saved. */
@FunctionalInterface
public interface PictureChooser {

    /**
     * Asks, and waits for the answer.
     *
     * @param name the name to suggest, with its extension
     * @return empty if the user thought better of it
     */
    Optional<Path> choose(Window owner, String name);

    /** Asks in the system's own dialog. */
    static PictureChooser ofSystem(Texts texts) {
        return (owner, name) -> {
            FileChooser chooser = new FileChooser();
            chooser.setTitle(texts.of("render.save"));
            chooser.setInitialFileName(name);
            for (ImageFormat format : ImageFormat.values()) {
                chooser.getExtensionFilters().add(new ExtensionFilter(
                        format.extension().toUpperCase(texts.locale()) + " – " + texts.of("format." + format.extension()), "*." + format.extension()));
            }
            return FileBox.toSave(chooser, owner, texts, file -> ImageFormat.ofFile(file).isPresent());
        };
    }
}
