package cz.paprsek.fx.view.camera;

import cz.paprsek.drawing.Segment;
import java.util.List;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;
import javafx.scene.canvas.Canvas;

/** The rectangle around all lines that are drawn on a canvas, and what stands at their ends. */
final class Extent {
    /** How far a letter, a ring or a line's width goes beyond a line at most, pixels. */
    private static final double AIR = 32;

    private final double width;
    private final double height;
    private double left = Double.POSITIVE_INFINITY;
    private double top = Double.POSITIVE_INFINITY;
    private double right = Double.NEGATIVE_INFINITY;
    private double bottom = Double.NEGATIVE_INFINITY;

    Extent(Canvas canvas) {
        width = canvas.getWidth();
        height = canvas.getHeight();
    }

    /** The same lines. */
    List<Segment> with(List<Segment> lines) {
        lines.forEach(line -> {
            with(line.x1(), line.y1());
            with(line.x2(), line.y2());
        });
        return lines;
    }

    void with(double x, double y) {
        left = Math.min(left, x);
        top = Math.min(top, y);
        right = Math.max(right, x);
        bottom = Math.max(bottom, y);
    }

    /** As far as it is on the canvas; of no size if there are no lines. */
    Bounds bounds() {
        if (left > right) {
            return new BoundingBox(0, 0, 0, 0);
        }
        double x = Math.max(0, left - AIR);
        double y = Math.max(0, top - AIR);
        return new BoundingBox(x, y, Math.max(0, Math.min(width, right + AIR) - x), Math.max(0, Math.min(height, bottom + AIR) - y));
    }
}
