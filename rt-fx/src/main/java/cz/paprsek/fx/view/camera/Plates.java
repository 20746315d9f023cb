package cz.paprsek.fx.view.camera;

import java.util.List;
import javafx.geometry.Bounds;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;
import javafx.scene.text.FontWeight;
import javafx.scene.text.Text;

/** Words above a picture, to be read on any. */
final class Plates {
    private static final Font FONT = Font.font("System", FontWeight.BOLD, 12);
    private static final double MARGIN = 6;

    private Plates() {}

    /** At the top of a picture; in one line for each of its parts, if it is too narrow for one. */
    static void above(GraphicsContext g, String text) {
        boolean fits = size(text).getWidth() + 2 * MARGIN <= g.getCanvas().getWidth();
        double top = 4;
        for (String line : fits ? List.of(text) : List.of(text.split("; ", -1))) {
            Bounds size = size(line);
            double x = Math.max(MARGIN, (g.getCanvas().getWidth() - size.getWidth()) / 2);
            g.setFill(Color.color(0, 0, 0, 0.75));
            g.fillRoundRect(x - MARGIN, top, size.getWidth() + 2 * MARGIN, size.getHeight() + MARGIN, 6, 6);
            g.setFont(FONT);
            g.setFill(Color.WHITE);
            g.fillText(line, x, top + MARGIN / 2 - size.getMinY());
            top += size.getHeight() + MARGIN + 1;
        }
    }

    private static Bounds size(String text) {
        Text measured = new Text(text);
        measured.setFont(FONT);
        return measured.getLayoutBounds();
    }

    /** A letter around a point. */
    static void letter(GraphicsContext g, String letter, double x, double y, Color color) {
        g.setFont(FONT);
        g.setLineWidth(3);
        g.setStroke(Color.BLACK);
        g.strokeText(letter, x - 3.5, y + 4);
        g.setFill(color);
        g.fillText(letter, x - 3.5, y + 4);
    }
}
