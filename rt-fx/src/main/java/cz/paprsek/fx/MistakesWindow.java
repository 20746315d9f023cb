package cz.paprsek.fx;

import cz.paprsek.fx.view.mistakes.MistakesPane;
import cz.paprsek.fx.view.texts.Shortcut;
import java.util.Optional;
import javafx.stage.Stage;
import org.jspecify.annotations.Nullable;

/** The window of the mistake laboratory; made when it is first needed. It shows the scene as it was when the window was asked for. */
final class MistakesWindow {
    private final Editor editor;
    private @Nullable Stage stage;
    private @Nullable MistakesPane pane;

    MistakesWindow(Editor editor) {
        this.editor = editor;
    }

    /** The window; empty if it has not been needed yet. */
    Optional<Stage> stage() {
        return Optional.ofNullable(stage);
    }

    void show() {
        Stage open = stage;
        if (open == null) {
            Stage shown = new Stage();
            open = shown;
            open.setScene(new javafx.scene.Scene(new javafx.scene.layout.StackPane(), 1280, 720));
            shown.getScene().getAccelerators().put(Shortcut.of("Shortcut+W"), shown::hide);
            WindowPlace.keep(open, editor.settings(), "window.mistakes", () -> Sizes.mostOfTheScreen(shown, 1280, 720));
            stage = open;
        }
        fill();
        open.show();
        open.toFront();
    }

    /** Makes the window's content anew, in the editor's language. */
    void fill() {
        if (stage != null) {
            close();
            pane = new MistakesPane(editor.model().scene(), editor.texts());
            stage.getScene().setRoot(pane);
            editor.theme().get().applyTo(stage.getScene());
            stage.setTitle(editor.texts().of("mistakes.title"));
        }
    }

    /** Ends what is being computed. */
    void close() {
        if (pane != null) {
            pane.close();
        }
    }
}
