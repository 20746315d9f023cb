package cz.paprsek.fx.view.look;

import java.util.OptionalInt;
import java.util.stream.IntStream;
import javafx.geometry.Bounds;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** Outlines of many things, of one colour and width. */
public interface Strokes {
    /** From how many things on speed counts more than smoothness. */
    int MANY = 2000;
    /** Of what may be drawn by itself, pixels each way. */
    int LARGEST_SQUARE = 20;

    /** Where the next line begins, pixels of the canvas. */
    void moveTo(double x, double y);

    /** A line to there, where the next one begins. */
    void lineTo(double x, double y);

    /** Whether nothing that is drawn within a rectangle would be seen any more, as the same colour is everywhere there. */
    default boolean hides(double fromX, double fromY, double toX, double toY) {
        return false;
    }

    /** After the lines of one thing. */
    void next();

    /** After all. */
    void end();

    /**
     * On a canvas.
     *
     * @param part where all is seen that is to be
     * @param areMany whether they are drawn as {@link ThinLines}, which have no dashes
     */
    static Strokes on(GraphicsContext g, Bounds part, double lineWidth, Color color, boolean areMany) {
        g.setLineWidth(lineWidth);
        g.setStroke(color);
        g.beginPath();
        return areMany ? new ThinLines(g, part, lineWidth, color) : new OneByOne(g);
    }

    /** Pixels of the screen for one of a canvas. */
    static double pixels(Canvas canvas) {
        return canvas.getScene() == null || canvas.getScene().getWindow() == null ? 1 : canvas.getScene().getWindow().getOutputScaleX();
    }

    /**
     * Of how many pixels of a canvas, each way, a square is of whole pixels of the screen; empty if of very many.
     *
     * @param pixels of the screen for one of the canvas
     */
    static OptionalInt square(double pixels) {
        return IntStream.rangeClosed(1, LARGEST_SQUARE).filter(size -> Math.abs(size * pixels - Math.rint(size * pixels)) < 1e-5).findFirst();
    }

    /**
     * As the canvas strokes them: a single path through ten thousand things takes three times as long.
     *
     * @param g of the canvas
     */
    record OneByOne(GraphicsContext g) implements Strokes {
        @Override
        public void moveTo(double x, double y) {
            g.moveTo(x, y);
        }

        @Override
        public void lineTo(double x, double y) {
            g.lineTo(x, y);
        }

        @Override
        public void next() {
            g.stroke();
            g.beginPath();
        }

        @Override
        public void end() {
            // All has been drawn.
        }
    }
}
