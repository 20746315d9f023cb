package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.view.look.Layer;
import java.util.Optional;
import java.util.function.Function;
import javafx.geometry.Bounds;
import javafx.scene.canvas.GraphicsContext;

/** What is drawn above a picture, in its own coordinates. */
final class Overlay extends Layer {
    private Function<GraphicsContext, Optional<Bounds>> painter = g -> Optional.empty();
    private Optional<Bounds> part = Optional.empty();

    /** @param name for style sheets and tests */
    Overlay(String name) {
        getStyleClass().add(name);
        setMouseTransparent(true);
        setManaged(false);
    }

    /** @param value tells within what it has drawn all; nothing if that may be anywhere */
    void setPainter(Function<GraphicsContext, Optional<Bounds>> value) {
        painter = value;
        repaint();
    }

    /** Lies where the picture is, as large as it. */
    void place(double x, double y, double width, double height) {
        relocate(x, y);
        if (width != getWidth() || height != getHeight()) {
            setSize(width, height);
            showAll();
            repaint();
        }
    }

    void repaint() {
        draw(new Object(), g -> part = getWidth() >= 1 && getHeight() >= 1 ? painter.apply(g) : Optional.empty());
        part.ifPresentOrElse(this::showOnly, this::showAll);
    }
}
