package cz.paprsek.fx.view.explain;

import cz.paprsek.math.Vec3;
import cz.paprsek.drawing.DrawingFrame;
import cz.paprsek.drawing.Projection;
import cz.paprsek.drawing.RayLine;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;

/** The rays of a tree in one projection. */
final class RayCanvas extends Region {
    private static final Color PAPER = Color.web("#f7f8fa");
    private static final Color OUTLINE = Color.web("#9aa3b0");
    private static final Color INK = Color.web("#30343a");

    private final Projection projection;
    private final Canvas canvas = new Canvas();
    private Optional<DrawingFrame> frame = Optional.empty();
    private List<RayLine> lines = List.of();
    private Set<String> shown = Set.of();
    private String highlighted = "";

    RayCanvas(Projection projection) {
        this.projection = projection;
        setMinSize(80, 80);
        setPrefSize(240, 240);
        getChildren().add(canvas);
    }

    /** Draws those lines whose ray is among the shown, the highlighted ray's bold. */
    void draw(DrawingFrame around, List<RayLine> all, Set<String> rays, String highlightedRay) {
        frame = Optional.of(around);
        lines = all;
        shown = rays;
        highlighted = highlightedRay;
        paint();
    }

    @Override
    protected void layoutChildren() {
        canvas.setWidth(getWidth());
        canvas.setHeight(getHeight());
        paint();
    }

    private void paint() {
        GraphicsContext g = canvas.getGraphicsContext2D();
        g.setLineDashes();
        g.setFill(PAPER);
        g.fillRect(0, 0, getWidth(), getHeight());
        g.setFill(INK);
        g.fillText(projection.title(), 6, 15);
        frame.ifPresent(around -> paint(g, around));
    }

    private void paint(GraphicsContext g, DrawingFrame around) {
        g.setStroke(OUTLINE);
        g.setLineWidth(1);
        for (List<Vec3> outline : around.outlines(projection)) {
            g.strokePolyline(outline.stream().mapToDouble(p -> x(around, p)).toArray(), outline.stream().mapToDouble(p -> y(around, p)).toArray(),
                    outline.size());
        }
        for (RayLine line : lines) {
            if (shown.contains(line.ray())) {
                paint(g, around, line);
            }
        }
    }

    private void paint(GraphicsContext g, DrawingFrame around, RayLine line) {
        boolean isBold = line.ray().equals(highlighted);
        Color color = Color.web(line.style().color());
        g.setStroke(color);
        g.setLineWidth(isBold ? 3 : 1.5);
        g.setLineDashes(line.style().dashes().stream().mapToDouble(Integer::doubleValue).toArray());
        double fromX = x(around, line.from());
        double fromY = y(around, line.from());
        double toX = x(around, line.to());
        double toY = y(around, line.to());
        g.strokeLine(fromX, fromY, toX, toY);
        g.setLineDashes();
        if (line.isRay() || line.style() == RayLine.Style.NORMAL) {
            arrow(g, color, toX, toY, toX - fromX, toY - fromY);
        }
        if (line.isRay() && isBold) {
            g.setFill(color);
            g.fillText(line.ray(), toX + 6, toY - 6);
        }
    }

    private static void arrow(GraphicsContext g, Color color, double x, double y, double dx, double dy) {
        double length = Math.hypot(dx, dy);
        if (length > 2) {
            double ux = 8 * dx / length;
            double uy = 8 * dy / length;
            g.setFill(color);
            g.fillPolygon(new double[] {x, x - ux + 0.35 * uy, x - ux - 0.35 * uy}, new double[] {y, y - uy - 0.35 * ux, y - uy + 0.35 * ux}, 3);
        }
    }

    private double side() {
        return Math.min(getWidth(), getHeight());
    }

    private double x(DrawingFrame around, Vec3 point) {
        return getWidth() / 2 + projection.right(point.minus(around.middle())) / around.size() * side();
    }

    private double y(DrawingFrame around, Vec3 point) {
        return getHeight() / 2 - projection.up(point.minus(around.middle())) / around.size() * side();
    }
}
