package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.view.picture.PicturePoint;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.Cursor;
import javafx.scene.Node;

/** Somebody for whom the next click into a picture is; whoever comes next takes their place, and they are told. */
final class AwaitedClick {
    private final Node picture;
    private Optional<Consumer<Optional<PicturePoint>>> waiting = Optional.empty();

    AwaitedClick(Node picture) {
        this.picture = picture;
    }

    /** @param onGivenUp is run if there is no click into the picture */
    void start(Consumer<PicturePoint> listener, Runnable onGivenUp) {
        end(Optional.empty());
        waiting = Optional.of(point -> point.ifPresentOrElse(listener, onGivenUp));
        picture.setCursor(Cursor.CROSSHAIR);
        picture.requestFocus();
    }

    /**
     * Waits no more, unless the one who is told asks for another click.
     *
     * @param point where was clicked; empty if not in the picture
     * @return whether somebody waited
     */
    boolean end(Optional<PicturePoint> point) {
        Optional<Consumer<Optional<PicturePoint>>> listener = waiting;
        waiting = Optional.empty();
        picture.setCursor(Cursor.DEFAULT);
        listener.ifPresent(known -> known.accept(point));
        return listener.isPresent();
    }
}
