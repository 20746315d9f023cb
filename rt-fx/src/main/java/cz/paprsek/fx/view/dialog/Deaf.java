package cz.paprsek.fx.view.dialog;

import java.util.List;
import java.util.function.Supplier;
import javafx.event.Event;
import javafx.event.EventHandler;
import javafx.scene.input.InputEvent;
import javafx.stage.Window;
import javafx.stage.WindowEvent;

/**
 * Windows that hear nothing of mouse and keyboard until a question over them is answered. JavaFX's own way, that of modal dialogs, fixes the size of the
 * windows behind (JDK-8332222), and some window managers then take a maximised one out of that state.
 */
public final class Deaf {
    private Deaf() {}

    /** Asks while all windows that are open are deaf. */
    public static <T> T during(Supplier<T> question) {
        List<Window> behind = List.copyOf(Window.getWindows());
        EventHandler<Event> deaf = Event::consume;
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
