package cz.paprsek.fx.view.rays;

import cz.paprsek.drawing.Segment;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** The outline of a body above the picture of a camera: dark below bright, to be seen on any picture. */
public final class BodyOutline {
    private static final int STEPS = 72;
    private static final int OF_MESHES = 24;

    private BodyOutline() {}

    /** How lines are drawn. */
    public enum Look {
        /** What is spoken of. */
        STRONG("#ff9b3d", 2),
        /** What is under the mouse. */
        FAINT("#fff3e0", 1),
        /** What is there. */
        BASE("#3fb950", 1.5),
        /** What is taken away. */
        CUTTER("#f85149", 1.5),
        /** Of which only the common part is left. */
        COMMON("#58a6ff", 1.5);

        private final String color;
        private final double width;

        Look(String color, double width) {
            this.color = color;
            this.width = width;
        }
    }

    /** Draws it, as far as it is on the canvas; nothing if the scene has no such body. */
    public static void draw(GraphicsContext g, RayPainter.Mapping picture, Scene scene, BodyAt at) {
        draw(g, picture, scene.camera().position(), scene, at, Look.STRONG);
    }

    /**
     * As above, seen from elsewhere.
     *
     * @param eye from where, world space
     */
    public static void draw(GraphicsContext g, RayPainter.Mapping picture, Vec3 eye, Scene scene, BodyAt at, Look look) {
        at.find(scene).ifPresent(body -> {
            Affine parent = at.parentToWorld(scene);
            boolean isGhost = look == Look.CUTTER || body.hidden();
            if (look != Look.CUTTER) {
                g.setLineDashes();
                draw(g, picture, eye, body, parent, Color.BLACK, look.width + 2);
            }
            g.setLineDashes(isGhost ? new double[] {5, 4} : new double[0]);
            draw(g, picture, eye, body, parent, Color.web(look.color), look.width);
            g.setLineDashes();
        });
    }

    private static void draw(GraphicsContext g, RayPainter.Mapping picture, Vec3 eye, Body body, Affine parent, Color color, double width) {
        Affine toWorld = parent.after(body.placement().toParent());
        for (Operand operand : body.operands()) {
            draw(g, picture, eye, Body.of(operand), toWorld, color, width);
        }
        g.setStroke(color);
        g.setLineWidth(width);
        double right = g.getCanvas().getWidth();
        double bottom = g.getCanvas().getHeight();
        Vec3 along = toWorld.inverse().direction(toWorld.point(Vec3.ZERO).minus(eye));
        g.beginPath();
        for (Curve curve : body.shape().outline(along.equals(Vec3.ZERO) ? Vec3.Z : along, body.shape() instanceof Mesh ? OF_MESHES : STEPS)) {
            Vec3 from = toWorld.point(curve.points().get(0));
            for (int i = 1; i < curve.points().size(); i++) {
                Vec3 to = toWorld.point(curve.points().get(i));
                for (Segment piece : picture.line(from, to)) {
                    piece.within(right, bottom).ifPresent(line -> {
                        g.moveTo(line.x1(), line.y1());
                        g.lineTo(line.x2(), line.y2());
                    });
                }
                from = to;
            }
        }
        g.stroke();
    }
}
