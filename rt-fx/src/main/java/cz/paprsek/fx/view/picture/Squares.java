package cz.paprsek.fx.view.picture;

import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.image.Image;

/** The part of a picture that is seen of it enlarged, each of its pixels as a square: an {@code ImageView} would blur them, whatever it is told. */
final class Squares extends Canvas {
    Squares() {
        setMouseTransparent(true);
        setVisible(false);
        setManaged(false);
    }

    /**
     * Draws it on a canvas of a size.
     *
     * @param left where the picture begins on the canvas
     * @param top likewise
     * @param zoom pixels of the canvas to one of the picture
     */
    void draw(Image picture, double left, double top, double zoom, double width, double height) {
        setWidth(width);
        setHeight(height);
        GraphicsContext graphics = getGraphicsContext2D();
        graphics.clearRect(0, 0, width, height);
        graphics.setImageSmoothing(false);
        double x0 = Math.max(0, Math.floor(-left / zoom));
        double y0 = Math.max(0, Math.floor(-top / zoom));
        double x1 = Math.min(picture.getWidth(), Math.ceil((width - left) / zoom));
        double y1 = Math.min(picture.getHeight(), Math.ceil((height - top) / zoom));
        if (x1 > x0 && y1 > y0) {
            graphics.drawImage(picture, x0, y0, x1 - x0, y1 - y0, left + x0 * zoom, top + y0 * zoom, (x1 - x0) * zoom, (y1 - y0) * zoom);
        }
    }
}
