package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.view.look.Palette;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;
import javafx.scene.text.FontWeight;
import javafx.scene.text.Text;
import javafx.scene.text.TextAlignment;

/** Text on a ground of its own, so that no line strikes it through, and within the pane, so that none of it is cut off. */
final class Plate {
    /** Of the ground about the text, pixels. */
    static final double MARGIN = 2;
    private static final Font FIGURES = Font.font("System", FontWeight.BOLD, 11);
    /** How much lower than a thing's foot the base of a name beside it is, pixels. */
    private static final double FOOT = 4;
    /** What is left free of names at the upper rim, for an axis' letter, and at the lower one, for numbers, pixels. */
    private static final double HEAD = 26;
    private static final double NUMBERS = 22;
    /** From a side of a thing to a name within it: as far as a handle reaches, pixels. */
    private static final double WITHIN = 7;
    /** From the mouse to its figures, pixels. */
    private static final double AWAY = 14;

    private Plate() {}

    /** Draws a line of text; the point is where it begins, at its base. */
    static void draw(GraphicsContext g, Viewport view, Font font, String text, Point2D at, Color color, Color ground) {
        Bounds size = size(font, text);
        double x = Math.max(MARGIN, Math.min(view.width() - size.getWidth() - MARGIN, at.getX()));
        double y = Math.max(MARGIN - size.getMinY(), Math.min(view.height() - MARGIN - size.getMaxY(), at.getY()));
        g.setFill(ground);
        g.fillRect(x - MARGIN, y + size.getMinY(), size.getWidth() + 2 * MARGIN, size.getHeight());
        g.setFont(font);
        g.setFill(color);
        g.setTextAlign(TextAlignment.LEFT);
        g.fillText(text, x, y);
    }

    /**
     * Where a name stands: to the right of a thing's foot, below it, above or to the left of it, beside its middle, else within it, below its upper side or above its lower one; within the pane,
     * and on nothing that is grabbed or is a sign; empty if there is no such place.
     *
     * @param thing about the thing, pixels
     * @param gap from it to the name, pixels, and likewise above it
     * @param taken what it may not lie on
     * @return the point where it begins, at its base
     */
    static Optional<Point2D> beside(Viewport view, Bounds name, Bounds thing, double gap, double gapAbove, List<Bounds> taken) {
        double middle = thing.getCenterX() - name.getWidth() / 2;
        double foot = thing.getMaxY() + FOOT;
        double half = thing.getCenterY() - name.getCenterY();
        double right = thing.getMaxX() + gap;
        double left = thing.getMinX() - gap - name.getWidth();
        double top = Math.max(thing.getMinY(), 0) + WITHIN - name.getMinY();
        double bottom = Math.min(thing.getMaxY(), view.height()) - WITHIN - name.getMaxY();
        return Stream.of(new Point2D(right, foot), new Point2D(middle, thing.getMaxY() + gap - name.getMinY()),
                        new Point2D(middle, thing.getMinY() - gapAbove - name.getMaxY()), new Point2D(left, foot),
                        new Point2D(right, half), new Point2D(left, half), new Point2D(middle, top), new Point2D(middle, bottom),
                        new Point2D((thing.getMinX() + middle) / 2, top), new Point2D((thing.getMaxX() + middle) / 2, top))
                .map(at -> new Point2D(Math.max(MARGIN, Math.min(view.width() - name.getWidth() - MARGIN, at.getX())), Math.min(view.height() - NUMBERS, Math.max(HEAD, at.getY()))))
                .filter(at -> taken.stream().noneMatch(ground(name, at)::intersects)).findFirst();
    }

    /** What a text covers that begins at a point. */
    static Bounds ground(Bounds text, Point2D at) {
        return new BoundingBox(at.getX() - MARGIN, at.getY() + text.getMinY(), text.getWidth() + 2 * MARGIN, text.getHeight());
    }

    /** Figures beside the mouse; nothing if there are none. */
    static void beside(GraphicsContext g, Viewport view, String figures, Point2D mouse, Palette palette) {
        if (!figures.isEmpty()) {
            draw(g, view, FIGURES, figures, mouse.add(AWAY, -AWAY), palette.selected(), palette.background());
        }
    }

    /** Where those are, pixels; they are kept within the pane. */
    static Bounds besides(Viewport view, String figures, Point2D mouse) {
        Bounds size = size(FIGURES, figures);
        double x = Math.min(mouse.getX() + AWAY, view.width() - size.getWidth()) - 2 * MARGIN;
        double y = Math.min(Math.max(0, mouse.getY() - AWAY + size.getMinY()), view.height() - size.getHeight()) - 2 * MARGIN;
        return new BoundingBox(Math.max(0, x), y, size.getWidth() + 4 * MARGIN, size.getHeight() + 4 * MARGIN);
    }

    static Bounds size(Font font, String text) {
        Text measured = new Text(text);
        measured.setFont(font);
        return measured.getLayoutBounds();
    }
}
