package cz.paprsek.fx.view.rays;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Operand;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** The outline of a body above the picture of a camera: dark below bright, to be seen on any picture. */
public final class BodyOutline {
    private static final int STEPS = 72;

    private BodyOutline() {}

    /** Draws it, as far as it is on the canvas; nothing if the scene has no such body. */
    public static void draw(GraphicsContext g, RayPainter.Mapping picture, Scene scene, BodyAt at) {
        at.find(scene).ifPresent(body -> {
            Affine parent = at.parentToWorld(scene);
            g.setLineDashes();
            draw(g, picture, scene.camera().position(), body, parent, Color.BLACK, 4);
            draw(g, picture, scene.camera().position(), body, parent, Color.web("#ff9b3d"), 2);
        });
    }

    private static void draw(GraphicsContext g, RayPainter.Mapping picture, Vec3 eye, Body body, Affine parent, Color color, double width) {
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
