package cz.paprsek.fx.view.camera;

import java.util.function.Consumer;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;

/** What is drawn above a picture, in its own coordinates. */
final class Overlay extends Canvas {
    private Consumer<GraphicsContext> painter = g -> {};

    Overlay() {
        setMouseTransparent(true);
        setManaged(false);
    }

    void setPainter(Consumer<GraphicsContext> value) {
        painter = value;
        repaint();
    }

    /** Lies where the picture is, as large as it. */
    void place(double x, double y, double width, double height) {
        relocate(x, y);
        if (width != getWidth() || height != getHeight()) {
            setWidth(width);
            setHeight(height);
            repaint();
        }
    }

    void repaint() {
        GraphicsContext g = getGraphicsContext2D();
        g.clearRect(0, 0, getWidth(), getHeight());
        if (getWidth() >= 1 && getHeight() >= 1) {
            painter.accept(g);
        }
    }
}
