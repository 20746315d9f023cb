package cz.paprsek.fx;

import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.present.PresenterPane;
import cz.paprsek.scene.Scene;
import java.util.Optional;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.StackPane;
import javafx.stage.Stage;
import org.jspecify.annotations.Nullable;

/** The window in which a pixel is explained before a class; made when it is first needed. It shows the scene as it was when the window was asked for. */
final class PresenterWindow {
    private final Editor editor;
    private @Nullable Stage stage;
    private @Nullable PresenterPane pane;

    PresenterWindow(Editor editor) {
        this.editor = editor;
    }

    /** The window; empty if it has not been needed yet. */
    Optional<Stage> stage() {
        return Optional.ofNullable(stage);
    }

    /** @param pixel to begin with; the one in the middle if there is none */
    void show(Optional<PicturePoint> pixel) {
        Scene scene = editor.model().state().seen();
        PresenterPane fresh;
        try {
            fresh = new PresenterPane(scene, editor.model().assets(), editor.texts(), editor.followTheme());
        } catch (IllegalArgumentException | ArithmeticException | OutOfMemoryError tooLarge) {
            editor.say(editor.texts().of("render.too-large", scene.settings().width(), scene.settings().height()));
            return;
        }
        Stage open = stage;
        if (open == null) {
            Stage shown = new Stage();
            open = shown;
            open.setScene(new javafx.scene.Scene(new StackPane(), 1024, 728));
            WindowPlace.keep(open, editor.settings(), "window.presenter", () -> Sizes.mostOfTheScreen(shown, 1024, 728));
            open.setFullScreenExitHint("");
            open.addEventHandler(KeyEvent.KEY_PRESSED, this::key);
            open.setOnHidden(event -> close());
            stage = open;
        }
        close();
        fill(open, fresh);
        pixel.ifPresentOrElse(point -> fresh.show(point.column(), point.row()), fresh::showMiddle);
        open.show();
        open.toFront();
    }

    /** Goes on in the editor's language, if something is shown. */
    void translate() {
        Stage open = stage;
        PresenterPane old = pane;
        if (open != null && old != null) {
            close();
            fill(open, old.translated(editor.texts(), editor.followTheme()));
        }
    }

    private void fill(Stage open, PresenterPane fresh) {
        pane = fresh;
        open.getScene().setRoot(fresh);
        editor.theme().get().applyTo(open.getScene());
        open.setTitle(editor.texts().of("present.title"));
        fresh.requestFocus();
    }

    private void key(KeyEvent event) {
        Stage open = stage;
        if (open != null && event.getCode() == KeyCode.F11) {
            open.setFullScreen(!open.isFullScreen());
        } else if (open != null && event.getCode() == KeyCode.ESCAPE && !open.isFullScreen()) {
            open.close();
        }
    }

    /** Ends what is being computed. */
    void close() {
        if (pane != null) {
            pane.close();
            pane = null;
        }
    }
}
