package cz.paprsek.fx;

import cz.paprsek.fx.view.PictureChooser;
import cz.paprsek.fx.view.RenderPane;
import javafx.scene.Scene;
import javafx.stage.Stage;
import org.jspecify.annotations.Nullable;

/** The window in which pictures are rendered; made when it is first needed, and kept with its pictures when it is closed. */
final class RenderWindow {
    private final Editor editor;
    private final Dialogs dialogs;
    private @Nullable Stage stage;
    private @Nullable RenderPane pane;

    RenderWindow(Editor editor, Dialogs dialogs) {
        this.editor = editor;
        this.dialogs = dialogs;
    }

    /** Shows the window and renders the scene as it asks to be. */
    void render() {
        RenderPane shown = show();
        shown.renderAsTheSceneAsks();
    }

    private RenderPane show() {
        Stage open = stage;
        RenderPane content = pane;
        if (open == null || content == null) {
            content = new RenderPane(editor.model(), editor.texts(), editor.theme(), dialogs.pictureChooser(editor.texts()), editor.treeChooser());
            open = new Stage();
            open.initOwner(editor.stage());
            open.setTitle(editor.texts().of("window.renders"));
            Scene scene = new Scene(content, 1000, 700);
            scene.getStylesheets().setAll(editor.stage().getScene().getStylesheets());
            open.setScene(scene);
            pane = content;
            stage = open;
        }
        open.show();
        open.toFront();
        return content;
    }

    /** Cancels what runs and closes the window. */
    void close() {
        if (pane != null) {
            pane.cancelAll();
        }
        if (stage != null) {
            stage.close();
        }
    }
}
