package cz.paprsek.fx.view.camera;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.view.rays.DrawnRays;
import cz.paprsek.fx.view.rays.RayPainter;
import java.util.Optional;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** Explained rays above the picture of a camera, as it would see them, and a ring around the pixel. */
final class RayOverlay extends Canvas {
    private static final double RING = 6;
    private Optional<DrawnRays> rays = Optional.empty();

    RayOverlay() {
        setMouseTransparent(true);
        setManaged(false);
    }

    void show(Optional<DrawnRays> drawn) {
        rays = drawn;
        paint();
    }

    /** Lies where the picture is, as large as it. */
    void place(double x, double y, double width, double height) {
        relocate(x, y);
        setWidth(width);
        setHeight(height);
        paint();
    }

    private void paint() {
        GraphicsContext g = getGraphicsContext2D();
        g.clearRect(0, 0, getWidth(), getHeight());
        rays.ifPresent(drawn -> {
            CameraView picture = new CameraView(drawn.frame().scene().camera(), getWidth(), getHeight());
            RayPainter.overPicture(g, picture::line).draw(drawn);
            drawn.eyeRay().map(ray -> picture.line(ray.from(), ray.to())).filter(pieces -> !pieces.isEmpty()).ifPresent(pieces -> {
                Segment at = pieces.get(pieces.size() - 1);
                ring(g, Color.BLACK, at.x2(), at.y2(), 4);
                ring(g, Color.WHITE, at.x2(), at.y2(), 2);
            });
        });
    }

    private static void ring(GraphicsContext g, Color color, double x, double y, double thickness) {
        g.setStroke(color);
        g.setLineWidth(thickness);
        g.strokeOval(x - RING, y - RING, 2 * RING, 2 * RING);
    }
}
