package cz.paprsek.fx;

import java.util.Optional;
import javafx.animation.AnimationTimer;
import javafx.application.Platform;
import javafx.event.EventHandler;
import javafx.geometry.Rectangle2D;
import javafx.stage.Screen;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;

/** How large windows are when they open. */
final class Sizes {
    private static final double SHARE = 0.85;
    /** Before this frame the first one is on the screen: while the second is made, the first may still be drawn. */
    private static final int PAINTED = 3;

    private Sizes() {}

    /** Gives a window most of the screen, but at least the given size in pixels; all of the screen if that is too small. */
    static void mostOfTheScreen(Stage stage, double width, double height) {
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        if (width >= screen.getWidth() || height >= screen.getHeight()) {
            // What it becomes when it is maximised no more, also while a question waits over it.
            stage.setWidth(Math.min(width, SHARE * screen.getWidth()));
            stage.setHeight(Math.min(height, SHARE * screen.getHeight()));
            stage.setMaximized(true);
        } else {
            opened(stage, Math.max(width, SHARE * screen.getWidth()), Math.max(height, SHARE * screen.getHeight()), Optional.empty());
        }
    }

    /** Gives a window a size in pixels, as far as its screen has room, and a place if it has one, when it is shown for the first time. What is told before makes its first picture the whole one rather than one of a corner; some window managers make it as small as can be nevertheless, until they are told again. */
    static void opened(Stage stage, double width, double height, Optional<Rectangle2D> place) {
        Rectangle2D before = screen(place).getVisualBounds();
        stage.setWidth(Math.min(width, before.getWidth()));
        stage.setHeight(Math.min(height, before.getHeight()));
        stage.addEventHandler(WindowEvent.WINDOW_SHOWN, new EventHandler<>() {
            @Override
            public void handle(WindowEvent event) {
                stage.removeEventHandler(WindowEvent.WINDOW_SHOWN, this);
                Platform.runLater(() -> {
                    if (stage.isMaximized()) {
                        return;
                    }
                    Rectangle2D room = screen(place).getVisualBounds();
                    stage.setWidth(Math.min(width, room.getWidth()));
                    stage.setHeight(Math.min(height, room.getHeight()));
                    place.ifPresentOrElse(known -> {
                        stage.setX(known.getMinX());
                        stage.setY(known.getMinY());
                    }, stage::centerOnScreen);
                });
            }
        });
    }

    /** Has a window not be seen before it has been painted, whenever it is shown, as far as the system can: on X11, where it is the compositor that makes windows transparent. */
    static void seenWhenPainted(Stage stage) {
        stage.addEventHandler(WindowEvent.WINDOW_SHOWING, event -> stage.setOpacity(0));
        stage.addEventHandler(WindowEvent.WINDOW_SHOWN, event -> new AnimationTimer() {
            private int frames;

            @Override
            public void handle(long now) {
                frames++;
                if (frames == PAINTED) {
                    stage.setOpacity(1);
                    stop();
                }
            }
        }.start());
    }

    private static Screen screen(Optional<Rectangle2D> place) {
        return place.flatMap(known -> Screen.getScreensForRectangle(known.getMinX(), known.getMinY(), known.getWidth(), known.getHeight()).stream().findFirst()).orElseGet(Screen::getPrimary);
    }
}
