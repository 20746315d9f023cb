package cz.paprsek.fx.view.rays;

import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.view.look.Strokes;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import java.util.List;
import java.util.function.Consumer;
import javafx.geometry.BoundingBox;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** The outline of a body above the picture of a camera: dark below bright, to be seen on any picture. */
public final class BodyOutline {
    private static final int STEPS = 72;
    private static final int OF_MESHES = 24;
    /** By how much a coarse circle may miss, pixels. */
    private static final double MISSED = 0.3;
    private static final int LEAST = 6;
    /** More than half of what a line is wide, pixels. */
    private static final double PEN = 3;

    private static final double[] GHOST = {5, 4};
    private static final double[] WHOLE = {};

    private BodyOutline() {}

    /** @param isBelow whether it makes lines seen that are drawn over its own; ghosts have none, and cover little */
    private record Pen(Color color, double width, boolean isDashed, boolean isBelow) {}

    /** How lines are drawn: of what is drawn together, later ones above. */
    public enum Look {
        /** What is under the mouse. */
        FAINT("#fff3e0", 1),
        /** What is there. */
        BASE("#3fb950", 1.5),
        /** What is taken away. */
        CUTTER("#f85149", 1.5),
        /** Of which only the common part is left. */
        COMMON("#58a6ff", 1.5),
        /** What is spoken of. */
        STRONG("#ff9b3d", 2);

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

    /**
     * Draws very many, each as finely as it is large, and without dashes.
     *
     * @param camera that they are seen by
     */
    public static void draw(GraphicsContext g, RayPainter.Mapping picture, Camera camera, Scene scene, List<BodyAt> bodies, Look look) {
        BoundingBox whole = new BoundingBox(0, 0, g.getCanvas().getWidth(), g.getCanvas().getHeight());
        Strokes below = Strokes.on(g, whole, look.width + 2, Color.BLACK, true);
        Strokes above = Strokes.on(g, whole, look.width, Color.web(look.color), true);
        List<Strokes> both = look == Look.CUTTER ? List.of(above) : List.of(below, above);
        for (BodyAt at : bodies) {
            at.find(scene).ifPresent(body -> roughly(picture, camera, body, at.parentToWorld(scene), whole, both));
        }
        both.forEach(Strokes::end);
    }

    private static void roughly(RayPainter.Mapping picture, Camera camera, Body body, Affine parent, BoundingBox whole, List<Strokes> both) {
        Affine toWorld = parent.after(body.placement().toParent());
        body.operands().forEach(operand -> roughly(picture, camera, Body.of(operand), toWorld, whole, both));
        Bounds box = body.shape().bounds().transformed(toWorld);
        double radius = radius(camera, box, whole.getHeight());
        boolean isHidden = Double.isFinite(radius) && picture.line(box.middle(), box.middle().plus(camera.right().times(1e-6))).stream()
                .allMatch(at -> both.stream().allMatch(lines -> lines.hides(at.x1() - radius, at.y1() - radius, at.x1() + radius, at.y1() + radius)));
        if (!isHidden) {
            // A polygon of n sides misses a circle by r (1 - cos(π/n)), which is about r (π/n)²/2.
            int steps = Double.isFinite(radius) ? (int) Math.min(STEPS, Math.max(LEAST, Math.ceil(Math.PI * Math.sqrt((radius - PEN) / 2 / MISSED)))) : STEPS;
            lines(picture, camera.position(), body, toWorld, steps, whole, piece -> both.forEach(lines -> {
                lines.moveTo(piece.x1(), piece.y1());
                lines.lineTo(piece.x2(), piece.y2());
            }));
        }
    }

    /**
     * How far from the middle of a box a picture shows anything of it at most, pixels; infinite if it might be far. A ball of radius r at a distance d, seen at an angle θ to the view, goes
     * to θ + arcsin(r/d), and no other way farther.
     *
     * @param height of the picture, pixels
     */
    private static double radius(Camera camera, Bounds box, double height) {
        Vec3 away = box.middle().minus(camera.position());
        double depth = away.dot(camera.forward());
        double radius = new Vec3(box.maxX(), box.maxY(), box.maxZ()).minus(box.middle()).length();
        boolean isFlat = camera.lens() instanceof Lens.Perspective || camera.lens() instanceof Lens.Orthographic;
        double across = Math.sqrt(Math.max(0, away.dot(away) - depth * depth)) / depth;
        double half = radius / Math.sqrt(away.dot(away) - radius * radius);
        double farther = (across + half) / (1 - across * half) - across;
        return isFlat && depth > 2 * radius && farther > 0 ? farther * depth * height / camera.lens().heightAt(depth) + PEN : Double.POSITIVE_INFINITY;
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
        g.beginPath();
        lines(picture, eye, body, toWorld, STEPS, new BoundingBox(0, 0, g.getCanvas().getWidth(), g.getCanvas().getHeight()), line -> {
            g.moveTo(line.x1(), line.y1());
            g.lineTo(line.x2(), line.y2());
        });
        g.stroke();
    }

    private static void lines(RayPainter.Mapping picture, Vec3 eye, Body body, Affine toWorld, int steps, BoundingBox whole, Consumer<Segment> drawing) {
        Vec3 along = toWorld.inverse().direction(toWorld.point(Vec3.ZERO).minus(eye));
        for (Curve curve : body.shape().outline(along.equals(Vec3.ZERO) ? Vec3.Z : along, body.shape() instanceof Mesh ? OF_MESHES : steps)) {
            Vec3 from = toWorld.point(curve.points().get(0));
            for (int i = 1; i < curve.points().size(); i++) {
                Vec3 to = toWorld.point(curve.points().get(i));
                picture.line(from, to).forEach(piece -> piece.within(whole.getWidth(), whole.getHeight()).ifPresent(drawing));
                from = to;
            }
        }
    }
}
