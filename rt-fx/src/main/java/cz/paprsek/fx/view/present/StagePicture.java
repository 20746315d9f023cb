package cz.paprsek.fx.view.present;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.drawing.RayLine;
import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.view.picture.PictureBuffer;
import cz.paprsek.fx.view.rays.BodyOutline;
import cz.paprsek.fx.view.rays.DrawnRays;
import cz.paprsek.fx.view.rays.RayPainter;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javafx.geometry.Point2D;
import javafx.geometry.Rectangle2D;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.image.ImageView;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import javafx.scene.shape.Rectangle;
import javafx.scene.shape.StrokeLineCap;

/** The picture as large as there is room for, whole or the part where the rays are, with the rays above it. */
final class StagePicture extends Region {
    /** How near to a ray the mouse means it, pixels of the screen. */
    private static final double NEAR = 7;
    private static final double SQUARES = 3;
    /** The part around the rays is at least so large, as a share of the picture. */
    private static final double LEAST_PART = 0.12;
    private static final Color GLOW = Color.web("#ff2bd6", 0.55);

    /** A ray as it is on the screen. */
    private record Drawn(RayLine line, Segment at) {}

    private final PictureBuffer buffer;
    private final ImageView view;
    private final Canvas overlay = new Canvas();
    private final List<Drawn> onScreen = new ArrayList<>();
    private Optional<DrawnRays> rays = Optional.empty();
    private Predicate<RayLine> glows = line -> false;
    private Optional<BodyAt> body = Optional.empty();
    private boolean zoomed;
    private double left;
    private double top;
    private double scale = 1;
    private Consumer<Point2D> onPixel = pixel -> {};
    private Consumer<RayLine> onRay = line -> {};
    private Consumer<Optional<RayLine>> onPointed = line -> {};

    StagePicture(PictureBuffer buffer) {
        this.buffer = buffer;
        view = new ImageView(buffer.image());
        setId("present-picture");
        setMinSize(200, 150);
        view.setManaged(false);
        overlay.setManaged(false);
        overlay.setMouseTransparent(true);
        Rectangle clip = new Rectangle();
        clip.widthProperty().bind(widthProperty());
        clip.heightProperty().bind(heightProperty());
        setClip(clip);
        getChildren().addAll(view, overlay);
        setOnMouseMoved(event -> onPointed.accept(near(event)));
        setOnMouseExited(event -> onPointed.accept(Optional.empty()));
        setOnMouseClicked(this::clicked);
    }

    void setOnPixel(Consumer<Point2D> listener) {
        onPixel = listener;
    }

    void setOnRay(Consumer<RayLine> listener) {
        onRay = listener;
    }

    /** Is told of the ray that the mouse is at. */
    void setOnPointed(Consumer<Optional<RayLine>> listener) {
        onPointed = listener;
    }

    /**
     * Draws rays.
     *
     * @param about what of them is meant
     * @param hit outlined; empty for none
     */
    void show(Optional<DrawnRays> drawn, Predicate<RayLine> about, Optional<BodyAt> hit) {
        rays = drawn;
        glows = about;
        body = hit;
        requestLayout();
    }

    /** Shows the part where the rays are, or the whole. */
    void zoom(boolean toRays) {
        zoomed = toRays;
        requestLayout();
    }

    @Override
    protected void layoutChildren() {
        Rectangle2D part = zoomed ? part() : new Rectangle2D(0, 0, buffer.width(), buffer.height());
        scale = Math.min(getWidth() / part.getWidth(), getHeight() / part.getHeight());
        left = getWidth() / 2 - scale * (part.getMinX() + part.getWidth() / 2);
        top = getHeight() / 2 - scale * (part.getMinY() + part.getHeight() / 2);
        view.setFitWidth(scale * buffer.width());
        view.setFitHeight(scale * buffer.height());
        view.setSmooth(scale < SQUARES);
        view.relocate(left, top);
        overlay.setWidth(getWidth());
        overlay.setHeight(getHeight());
        paint();
    }

    /** What lies around the rays, as far as it is in the picture. */
    private Rectangle2D part() {
        double width = buffer.width();
        double height = buffer.height();
        double[] box = {Double.MAX_VALUE, Double.MAX_VALUE, 0, 0};
        rays.ifPresent(drawn -> {
            CameraView eye = new CameraView(drawn.frame().scene().camera(), width, height);
            drawn.lines().stream().filter(line -> line.style() != RayLine.Style.SHADOW_FREE && line.style() != RayLine.Style.SHADOW_BLOCKED)
                    .flatMap(line -> eye.line(line.from(), line.to()).stream()).flatMap(line -> line.within(width, height).stream()).forEach(line -> {
                        box[0] = Math.min(box[0], Math.min(line.x1(), line.x2()));
                        box[1] = Math.min(box[1], Math.min(line.y1(), line.y2()));
                        box[2] = Math.max(box[2], Math.max(line.x1(), line.x2()));
                        box[3] = Math.max(box[3], Math.max(line.y1(), line.y2()));
                    });
        });
        if (box[0] > box[2]) {
            return new Rectangle2D(0, 0, width, height);
        }
        double w = Math.min(width, Math.max(LEAST_PART * width, 1.2 * (box[2] - box[0])));
        double h = Math.min(height, Math.max(LEAST_PART * height, 1.2 * (box[3] - box[1])));
        return new Rectangle2D(Math.max(0, Math.min(width - w, (box[0] + box[2] - w) / 2)), Math.max(0, Math.min(height - h, (box[1] + box[3] - h) / 2)), w, h);
    }

    private void paint() {
        GraphicsContext g = overlay.getGraphicsContext2D();
        g.clearRect(0, 0, overlay.getWidth(), overlay.getHeight());
        onScreen.clear();
        rays.ifPresent(drawn -> {
            CameraView eye = new CameraView(drawn.frame().scene().camera(), scale * buffer.width(), scale * buffer.height());
            RayPainter.Mapping mapping = (from, to) -> placed(eye, from, to);
            body.ifPresent(hit -> BodyOutline.draw(g, mapping, drawn.frame().scene(), hit));
            drawn.visible().forEach(line -> mapping.line(line.from(), line.to()).forEach(piece -> onScreen.add(new Drawn(line, piece))));
            g.setStroke(GLOW);
            g.setLineWidth(13);
            g.setLineCap(StrokeLineCap.ROUND);
            onScreen.stream().filter(shown -> glows.test(shown.line)).flatMap(shown -> shown.at.within(getWidth(), getHeight()).stream())
                    .forEach(seen -> g.strokeLine(seen.x1(), seen.y1(), seen.x2(), seen.y2()));
            RayPainter.overPicture(g, mapping).draw(drawn);
            drawn.eyeRay().map(ray -> mapping.line(ray.from(), ray.to())).filter(pieces -> !pieces.isEmpty()).ifPresent(pieces -> {
                Segment at = pieces.get(pieces.size() - 1);
                ring(g, Color.BLACK, at, 5);
                ring(g, Color.WHITE, at, 2.5);
            });
        });
    }

    private List<Segment> placed(CameraView eye, Vec3 from, Vec3 to) {
        return eye.line(from, to).stream().map(line -> new Segment(left + line.x1(), top + line.y1(), left + line.x2(), top + line.y2())).toList();
    }

    /** Around the pixel's square, if that is large enough to be seen. */
    private void ring(GraphicsContext g, Color color, Segment ray, double thickness) {
        double radius = Math.max(9, scale);
        g.setLineDashes();
        g.setStroke(color);
        g.setLineWidth(thickness);
        g.strokeOval(ray.x2() - radius, ray.y2() - radius, 2 * radius, 2 * radius);
    }

    private void clicked(MouseEvent event) {
        Optional<RayLine> line = near(event);
        line.ifPresent(onRay);
        double column = (event.getX() - left) / scale;
        double row = (event.getY() - top) / scale;
        if (line.isEmpty() && column >= 0 && row >= 0 && column < buffer.width() && row < buffer.height()) {
            onPixel.accept(new Point2D(column, row));
        }
    }

    private Optional<RayLine> near(MouseEvent event) {
        Drawn best = null;
        double least = NEAR;
        for (Drawn drawn : onScreen) {
            double distance = distance(drawn.at, event.getX(), event.getY());
            if (distance < least) {
                least = distance;
                best = drawn;
            }
        }
        return Optional.ofNullable(best).map(Drawn::line);
    }

    private static double distance(Segment line, double x, double y) {
        double dx = line.x2() - line.x1();
        double dy = line.y2() - line.y1();
        double squared = dx * dx + dy * dy;
        double along = squared > 0 ? Math.max(0, Math.min(1, ((x - line.x1()) * dx + (y - line.y1()) * dy) / squared)) : 0;
        return Math.hypot(x - line.x1() - along * dx, y - line.y1() - along * dy);
    }
}
