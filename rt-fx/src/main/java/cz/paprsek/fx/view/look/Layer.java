package cz.paprsek.fx.view.look;

import java.util.function.Consumer;
import javafx.geometry.Bounds;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.shape.Rectangle;
import org.jspecify.annotations.Nullable;

/**
 * One of several canvases above each other, which is drawn anew only when it is to show something else. Where little of it changes from one frame to the next, that part
 * alone is shown, since JavaFX paints anew, with all that lies below, whatever a canvas covers.
 */
public class Layer extends Canvas {
    private final Rectangle part = new Rectangle();
    private @Nullable Object shown;
    private int drawings;

    /** One with a name for style sheets and tests. */
    public static Layer named(String name) {
        Layer layer = new Layer();
        layer.getStyleClass().add(name);
        return layer;
    }

    public final void setSize(double width, double height) {
        setWidth(width);
        setHeight(height);
    }

    /**
     * Draws, on nothing, unless the layer shows the same already.
     *
     * @param what all that the drawing depends on
     */
    public final void draw(Object what, Consumer<GraphicsContext> painter) {
        if (!what.equals(shown)) {
            shown = what;
            drawings++;
            GraphicsContext g = getGraphicsContext2D();
            // Nothing has been drawn elsewhere; to clear all takes JavaFX as long as to paint it.
            if (getClip() == null) {
                g.clearRect(0, 0, getWidth(), getHeight());
            } else {
                g.clearRect(part.getX(), part.getY(), part.getWidth(), part.getHeight());
            }
            painter.accept(g);
        }
    }

    /** Shows what lies within bounds, pixels, and what was shown before no more. All that has been drawn lies there. */
    public final void showOnly(Bounds bounds) {
        part.setX(Math.floor(bounds.getMinX()));
        part.setY(Math.floor(bounds.getMinY()));
        part.setWidth(Math.max(0, Math.ceil(bounds.getMaxX()) - part.getX()));
        part.setHeight(Math.max(0, Math.ceil(bounds.getMaxY()) - part.getY()));
        setClip(part);
    }

    /** Shows all of it. */
    public final void showAll() {
        setClip(null);
    }

    /**
     * Draws a part anew, whatever it depends on; all else stays as it is.
     *
     * @param part that begins and ends between pixels of the screen
     */
    public final void mend(Bounds part, Consumer<GraphicsContext> painter) {
        GraphicsContext g = getGraphicsContext2D();
        g.save();
        g.beginPath();
        g.rect(part.getMinX(), part.getMinY(), part.getWidth(), part.getHeight());
        g.clip();
        g.clearRect(part.getMinX(), part.getMinY(), part.getWidth(), part.getHeight());
        painter.accept(g);
        g.restore();
    }

    /** How often all of it has been drawn. */
    public final int drawings() {
        return drawings;
    }
}
