package cz.paprsek.fx;

import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.render.RenderDesk;
import cz.paprsek.fx.view.render.RenderPane;
import cz.paprsek.fx.view.render.fields.Remembered;
import java.util.Optional;
import java.util.Set;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.value.ObservableValue;
import javafx.scene.Scene;
import javafx.scene.input.KeyCombination;
import javafx.stage.Stage;
import org.jspecify.annotations.Nullable;

/** The window in which pictures are rendered; made when it is first needed, and kept with its pictures when it is closed. */
final class RenderWindow {
    /** The key of the settings. */
    private static final String SAID = "render";

    private final Editor editor;
    private final Dialogs dialogs;
    private final RenderDesk desk;
    private ObservableValue<Theme> theme;
    private @Nullable Stage stage;
    private @Nullable RenderPane pane;
    private final ReadOnlyStringWrapper status = new ReadOnlyStringWrapper("");

    RenderWindow(Editor editor, Dialogs dialogs) {
        this.editor = editor;
        this.dialogs = dialogs;
        // What is looked into, and by which light, is a matter of the moment.
        this.desk = new RenderDesk(Remembered.kept(editor.settings().get(SAID), text -> editor.settings().set(SAID, text), Set.of("mode", "lights")));
        this.theme = editor.followTheme();
    }

    /** Shows the window and renders the scene as was said last, else as it asks to be. */
    void render() {
        show().render();
    }

    /** Shows the window and asks how to render. */
    void ask() {
        show().ask();
    }

    /** Shows the window with the pictures there are. */
    void open() {
        show();
    }

    /** What has become of the last render, in words. */
    ReadOnlyStringProperty statusProperty() {
        return status.getReadOnlyProperty();
    }

    /** Speaks the editor's language from now on. */
    void translate() {
        RenderPane old = pane;
        if (old != null && stage != null) {
            RenderPane fresh = content();
            fresh.takeOver(old);
            pane = fresh;
            stage.setTitle(editor.texts().of("window.renders"));
            stage.getScene().setRoot(fresh);
        }
    }

    private RenderPane content() {
        theme = editor.followTheme();
        RenderPane content = new RenderPane(
                editor.model(), desk, editor.texts(), theme, dialogs.pictureChooser(editor.texts()), editor.treeChooser());
        status.bind(content.statusProperty());
        return content;
    }

    private RenderPane show() {
        Stage open = stage;
        RenderPane content = pane;
        if (open == null || content == null) {
            content = content();
            open = new Stage();
            open.initOwner(editor.stage());
            open.setTitle(editor.texts().of("window.renders"));
            Stage window = open;
            Scene scene = new Scene(content, 1000, 700);
            scene.getStylesheets().setAll(editor.stage().getScene().getStylesheets());
            scene.getAccelerators().put(KeyCombination.valueOf("Shortcut+W"), window::hide);
            open.setScene(scene);
            WindowPlace.keep(window, editor.settings(), "window.renders", () -> Sizes.opened(window, 1000, 740, Optional.empty()));
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
