package cz.paprsek.fx.view.rays;

import cz.paprsek.drawing.Segment;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** The outline of a body above the picture of a camera: dark below bright, to be seen on any picture. */
public final class BodyOutline {
    private static final int STEPS = 72;
    private static final int OF_MESHES = 24;

    private static final double[] GHOST = {5, 4};
    private static final double[] WHOLE = {};

    private BodyOutline() {}

    /** @param isBelow whether it makes lines seen that are drawn over its own; ghosts have none, and cover little */
    private record Pen(Color color, double width, boolean isDashed, boolean isBelow) {}

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
            if (look != Look.CUTTER) {
                draw(g, picture, eye, body, parent, new Pen(Color.BLACK, look.width + 2, false, true), false);
            }
            draw(g, picture, eye, body, parent, new Pen(Color.web(look.color), look.width, look == Look.CUTTER || body.hidden(), false), false);
            g.setLineDashes();
        });
    }

    /** @param isCut whether it is taken away from what it is a part of */
    private static void draw(GraphicsContext g, RayPainter.Mapping picture, Vec3 eye, Body body, Affine parent, Pen pen, boolean isCut) {
        Affine toWorld = parent.after(body.placement().toParent());
        for (int i = 0; i < body.operands().size(); i++) {
            boolean isTakenAway = i > 0 && body.shape() instanceof Csg csg && csg.operation() == Csg.Operation.DIFFERENCE;
            draw(g, picture, eye, Body.of(body.operands().get(i)), toWorld, pen, isCut != isTakenAway);
        }
        if (isCut && pen.isBelow) {
            return;
        }
        g.setLineDashes(pen.isDashed || isCut ? GHOST : WHOLE);
        g.setStroke(pen.color);
        g.setLineWidth(pen.width);
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
