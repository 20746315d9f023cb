package cz.paprsek.fx.view.explain;

import cz.paprsek.drawing.DrawingFrame;
import cz.paprsek.drawing.Projection;
import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.view.look.Palette;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.rays.DrawnRays;
import cz.paprsek.fx.view.rays.RayPainter;
import cz.paprsek.math.Vec3;
import java.util.List;
import java.util.Optional;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Bounds;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.layout.Region;
import javafx.scene.text.Font;
import javafx.scene.text.Text;

/** The rays of a tree in one projection, with the outlines of what they meet. */
final class RayCanvas extends Region {
    /** Beside the name, pixels. */
    private static final double MARGIN = 6;

    private final Projection projection;
    private final String title;
    private final ObservableValue<Theme> theme;
    private final Canvas canvas = new Canvas();
    private Optional<DrawnRays> rays = Optional.empty();
    private List<List<Vec3>> outlines = List.of();

    RayCanvas(Projection projection, String title, ObservableValue<Theme> theme) {
        this.projection = projection;
        this.title = title;
        this.theme = theme;
        setMinSize(80, 80);
        setPrefSize(240, 240);
        getChildren().add(canvas);
        theme.addListener((property, old, now) -> paint());
    }

    void draw(Optional<DrawnRays> drawn) {
        if (!drawn.map(DrawnRays::frame).equals(rays.map(DrawnRays::frame))) {
            outlines = drawn.map(now -> now.frame().outlines(projection)).orElse(List.of());
        }
        rays = drawn;
        paint();
    }

    @Override
    protected void layoutChildren() {
        canvas.setWidth(getWidth());
        canvas.setHeight(getHeight());
        paint();
    }

    private void paint() {
        Palette palette = theme.getValue().palette();
        GraphicsContext g = canvas.getGraphicsContext2D();
        g.setLineDashes();
        g.setFill(palette.background());
        g.fillRect(0, 0, getWidth(), getHeight());
        rays.ifPresent(now -> {
            g.setStroke(palette.text());
            g.setLineWidth(1);
            outlines.forEach(curve -> outline(g, now.frame(), curve));
            RayPainter.on(g, theme.getValue(), (from, to) -> List.of(segment(now.frame(), from, to))).draw(now);
        });
        name(g, palette);
    }

    /** On a ground of its own, so that no ray strikes it through. */
    private void name(GraphicsContext g, Palette palette) {
        Text name = new Text(title);
        name.setFont(Font.font("System", 12));
        Bounds size = name.getLayoutBounds();
        g.setFill(palette.background());
        g.fillRect(0, 0, size.getWidth() + 2 * MARGIN, size.getHeight() + MARGIN);
        g.setFont(name.getFont());
        g.setFill(palette.text());
        g.fillText(title, MARGIN, MARGIN / 2 - size.getMinY());
    }

    private void outline(GraphicsContext g, DrawingFrame frame, List<Vec3> curve) {
        for (int i = 1; i < curve.size(); i++) {
            segment(frame, curve.get(i - 1), curve.get(i)).within(getWidth(), getHeight())
                    .ifPresent(seen -> g.strokeLine(seen.x1(), seen.y1(), seen.x2(), seen.y2()));
        }
    }

    private Segment segment(DrawingFrame frame, Vec3 from, Vec3 to) {
        return new Segment(x(frame, from), y(frame, from), x(frame, to), y(frame, to));
    }

    private double side() {
        return Math.min(getWidth(), getHeight());
    }

    private double x(DrawingFrame frame, Vec3 point) {
        return getWidth() / 2 + projection.right(point.minus(frame.middle())) / frame.size() * side();
    }

    private double y(DrawingFrame frame, Vec3 point) {
        return getHeight() / 2 - projection.up(point.minus(frame.middle())) / frame.size() * side();
    }
}
