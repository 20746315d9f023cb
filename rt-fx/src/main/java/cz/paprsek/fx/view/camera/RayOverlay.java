package cz.paprsek.fx.view.camera;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.view.rays.DrawnRays;
import cz.paprsek.fx.view.rays.RayPainter;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** Explained rays above the picture of a camera, as it would see them, and a ring around the pixel. */
final class RayOverlay {
    private static final double RING = 6;

    private RayOverlay() {}

    static void paint(GraphicsContext g, DrawnRays drawn) {
        CameraView picture = new CameraView(drawn.frame().scene().camera(), g.getCanvas().getWidth(), g.getCanvas().getHeight());
        RayPainter.overPicture(g, picture::line).draw(drawn);
        drawn.eyeRay().map(ray -> picture.line(ray.from(), ray.to())).filter(pieces -> !pieces.isEmpty()).ifPresent(pieces -> {
            Segment at = pieces.get(pieces.size() - 1);
            ring(g, Color.BLACK, at.x2(), at.y2(), 4);
            ring(g, Color.WHITE, at.x2(), at.y2(), 2);
        });
    }

    private static void ring(GraphicsContext g, Color color, double x, double y, double thickness) {
        g.setStroke(color);
        g.setLineWidth(thickness);
        g.strokeOval(x - RING, y - RING, 2 * RING, 2 * RING);
    }
}
