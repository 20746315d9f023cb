package cz.paprsek.fx;

import cz.paprsek.fx.model.file.Settings;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javafx.geometry.Rectangle2D;
import javafx.stage.Screen;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;

/**
 * Where a window stood last and how large it was.
 *
 * @param bounds on the screen, pixels; of a maximised window, where it would be otherwise
 * @param maximized whether it filled the screen
 */
record WindowPlace(Rectangle2D bounds, boolean maximized) {
    private static final Pattern TEXT = Pattern.compile("(-?\\d{1,6}) (-?\\d{1,6}) (\\d{1,6}) (\\d{1,6})( maximized)?");
    /** So much of a window must be on a screen to be taken hold of, pixels. */
    private static final double LEAST = 100;

    /**
     * Puts a window where it was when it was closed last, and remembers where it is when it is closed. It is seen when it has been painted.
     *
     * @param key of the settings
     * @param otherwise gives a size to a window that has never been open, or whose screen is gone
     */
    static void keep(Stage stage, Settings settings, String key, Runnable otherwise) {
        Optional<WindowPlace> place = settings.get(key).flatMap(WindowPlace::parse).filter(WindowPlace::isOnAScreen);
        place.ifPresentOrElse(known -> known.apply(stage), otherwise);
        Follower follower = new Follower(stage, place.map(WindowPlace::bounds));
        Sizes.seenWhenPainted(stage);
        stage.addEventHandler(WindowEvent.WINDOW_HIDING, event -> follower.place().ifPresent(now -> settings.set(key, now.text())));
    }

    static Optional<WindowPlace> parse(String text) {
        Matcher m = TEXT.matcher(text);
        if (!m.matches()) {
            return Optional.empty();
        }
        return Optional.of(new WindowPlace(new Rectangle2D(
                Integer.parseInt(m.group(1)), Integer.parseInt(m.group(2)), Integer.parseInt(m.group(3)), Integer.parseInt(m.group(4))), m.group(5) != null));
    }

    String text() {
        return String.format(Locale.ROOT, "%.0f %.0f %.0f %.0f%s", bounds.getMinX(), bounds.getMinY(), bounds.getWidth(), bounds.getHeight(),
                maximized ? " maximized" : "");
    }

    private boolean isOnAScreen() {
        return !Screen.getScreensForRectangle(bounds.getMinX() + LEAST / 2, bounds.getMinY(), Math.max(1, bounds.getWidth() - LEAST), 1).isEmpty();
    }

    private void apply(Stage stage) {
        Sizes.opened(stage, bounds.getWidth(), bounds.getHeight(), Optional.of(bounds));
        stage.setMaximized(maximized);
    }

    /** Remembers the last bounds that were not those of the whole screen. */
    private static final class Follower {
        private final Stage stage;
        private Optional<Rectangle2D> normal;

        Follower(Stage stage, Optional<Rectangle2D> before) {
            this.stage = stage;
            this.normal = before;
            stage.xProperty().addListener(property -> look());
            stage.yProperty().addListener(property -> look());
            stage.widthProperty().addListener(property -> look());
            stage.heightProperty().addListener(property -> look());
        }

        private void look() {
            boolean isNormal = stage.isShowing() && !stage.isMaximized() && !stage.isIconified() && !stage.isFullScreen();
            if (isNormal && stage.getWidth() > 0 && stage.getHeight() > 0) {
                normal = Optional.of(new Rectangle2D(stage.getX(), stage.getY(), stage.getWidth(), stage.getHeight()));
            }
        }

        Optional<WindowPlace> place() {
            return normal.map(bounds -> new WindowPlace(bounds, stage.isMaximized()));
        }
    }
}
