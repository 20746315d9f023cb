package cz.paprsek.fx.view.dialog;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.application.Platform;
import javafx.event.Event;
import javafx.event.EventHandler;
import javafx.scene.Scene;
import javafx.scene.control.Dialog;
import javafx.scene.input.InputEvent;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.stage.Modality;
import javafx.stage.Window;
import javafx.stage.WindowEvent;

/**
 * Windows that hear nothing of mouse and keyboard until a question over them is answered. JavaFX's own way, that of modal dialogs, fixes the size of the
 * windows behind (JDK-8332222), and some window managers then take a maximised one out of that state.
 */
public final class Deaf {
    private Deaf() {}

    /** Shows a dialog, and lets nothing else be done until it is answered. */
    public static <T> Optional<T> ask(Dialog<T> dialog, Window owner) {
        over(dialog, owner);
        return during(dialog::showAndWait, () -> window(dialog).ifPresent(Window::requestFocus));
    }

    /** Has a dialog stand over a window, of which it is independent: some window managers put what is not modal into a corner. */
    public static void over(Dialog<?> dialog, Window owner) {
        dialog.initOwner(owner);
        dialog.initModality(Modality.NONE);
        dialog.setOnShown(event -> Platform.runLater(() -> window(dialog).ifPresent(shown -> {
            shown.setX(owner.getX() + (owner.getWidth() - shown.getWidth()) / 2);
            shown.setY(owner.getY() + (owner.getHeight() - shown.getHeight()) / 3);
        })));
    }

    /** None if a quick hand has answered it already. */
    private static Optional<Window> window(Dialog<?> dialog) {
        return Optional.ofNullable(dialog.getDialogPane().getScene()).map(Scene::getWindow);
    }

    /** Asks while all windows that are open are deaf. */
    public static <T> T during(Supplier<T> question) {
        return during(question, () -> {});
    }

    /** @param onPressed when a button or key has been pressed in one of these: the window manager has given it the keyboard, which is the question's */
    static <T> T during(Supplier<T> question, Runnable onPressed) {
        List<Window> behind = List.copyOf(Window.getWindows());
        EventHandler<Event> deaf = event -> {
            event.consume();
            if (event.getEventType() == MouseEvent.MOUSE_PRESSED || event.getEventType() == KeyEvent.KEY_PRESSED) {
                onPressed.run();
            }
        };
        behind.forEach(window -> {
            window.addEventFilter(InputEvent.ANY, deaf);
            window.addEventFilter(WindowEvent.WINDOW_CLOSE_REQUEST, deaf);
        });
        try {
            return question.get();
        } finally {
            behind.forEach(window -> {
                window.removeEventFilter(InputEvent.ANY, deaf);
                window.removeEventFilter(WindowEvent.WINDOW_CLOSE_REQUEST, deaf);
            });
        }
    }
}
