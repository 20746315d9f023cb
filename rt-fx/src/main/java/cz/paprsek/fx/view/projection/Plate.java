package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.view.look.Palette;
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

    /** Figures beside the mouse; nothing if there are none. */
    static void beside(GraphicsContext g, Viewport view, String figures, Point2D mouse, Palette palette) {
        if (!figures.isEmpty()) {
            draw(g, view, FIGURES, figures, mouse.add(AWAY, -AWAY), palette.selected(), palette.background());
        }
    }

    static Bounds size(Font font, String text) {
        Text measured = new Text(text);
        measured.setFont(font);
        return measured.getLayoutBounds();
    }
}
