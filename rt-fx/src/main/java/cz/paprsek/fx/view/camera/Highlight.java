package cz.paprsek.fx.view.camera;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Operand;
import java.util.Optional;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** The outline of a body above the picture of a camera. */
final class Highlight extends Canvas {
    private static final int STEPS = 72;

    Highlight() {
        setMouseTransparent(true);
        setManaged(false);
    }

    /** Draws a body's outline, or none any more. */
    void show(Scene scene, Optional<BodyAt> at) {
        GraphicsContext g = getGraphicsContext2D();
        g.clearRect(0, 0, getWidth(), getHeight());
        at.flatMap(place -> place.find(scene)).ifPresent(body -> {
            CameraView picture = new CameraView(scene.camera(), getWidth(), getHeight());
            Affine parent = at.orElseThrow().parentToWorld(scene);
            // Dark below bright, to be seen on any picture.
            draw(g, picture, scene.camera().position(), body, parent, Color.BLACK, 4);
            draw(g, picture, scene.camera().position(), body, parent, Color.web("#ff9b3d"), 2);
        });
    }

    private static void draw(GraphicsContext g, CameraView picture, Vec3 eye, Body body, Affine parent, Color color, double width) {
        Affine toWorld = parent.after(body.placement().toParent());
        for (Operand operand : body.operands()) {
            draw(g, picture, eye, Body.of(operand), toWorld, color, width);
        }
        g.setStroke(color);
        g.setLineWidth(width);
        Vec3 along = toWorld.inverse().direction(toWorld.point(Vec3.ZERO).minus(eye));
        for (Curve curve : body.shape().outline(along.equals(Vec3.ZERO) ? Vec3.Z : along, STEPS)) {
            for (int i = 1; i < curve.points().size(); i++) {
                picture.line(toWorld.point(curve.points().get(i - 1)), toWorld.point(curve.points().get(i))).stream()
                        .flatMap(line -> line.within(g.getCanvas().getWidth(), g.getCanvas().getHeight()).stream())
                        .forEach(line -> g.strokeLine(line.x1(), line.y1(), line.x2(), line.y2()));
            }
        }
    }
}
