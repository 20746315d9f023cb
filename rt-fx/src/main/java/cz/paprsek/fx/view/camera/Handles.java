package cz.paprsek.fx.view.camera;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** What is grabbed in a picture to move, turn or scale what is selected: three axes, or rings about them, through a point, and something in the middle. */
public final class Handles {
    /** From the middle to the ends, pixels. */
    private static final double LENGTH = 62;
    /** How near the mouse must come, pixels. */
    private static final double REACH = 7;
    /** How large the middle is, pixels. */
    private static final double MIDDLE = 8;
    private static final int PIECES = 48;
    private static final Color HELD = Color.web("#ffd33d");

    /** What they do. */
    public enum Mode { MOVE, TURN, SCALE }

    private final Mode mode;
    private final CameraView view;
    private final Vec3 eye;
    private final Vec3 middle;
    private final Point2D place;
    private final double scale;
    private final Map<Axis, List<Segment>> lines = new EnumMap<>(Axis.class);

    private Handles(Mode mode, CameraView view, Camera camera, Vec3 middle, Point2D place, double scale) {
        this.mode = mode;
        this.view = view;
        this.eye = camera.position();
        this.middle = middle;
        this.place = place;
        this.scale = scale;
        for (Axis axis : Axis.values()) {
            lines.put(axis, mode == Mode.TURN ? ring(axis) : view.line(middle, middle.plus(axis.times(LENGTH / scale))));
        }
    }

    /** Those of a point, if it is seen. */
    static Optional<Handles> of(Mode mode, Camera camera, double width, double height, Vec3 middle) {
        CameraView view = new CameraView(camera, width, height);
        double ahead = middle.minus(camera.position()).dot(camera.forward());
        double scale = height / camera.lens().heightAt(ahead);
        return ahead <= 0 || !(scale > 0) ? Optional.empty()
                : place(view, camera, middle, scale).map(at -> new Handles(mode, view, camera, middle, at, scale));
    }

    private static Optional<Point2D> place(CameraView view, Camera camera, Vec3 point, double scale) {
        List<Segment> line = view.line(point, point.plus(camera.right().times(1 / scale)));
        return line.isEmpty() ? Optional.empty() : Optional.of(new Point2D(line.get(0).x1(), line.get(0).y1()));
    }

    private List<Segment> ring(Axis axis) {
        Vec3 u = axis == Axis.X ? Vec3.Y : Vec3.X;
        Vec3 v = axis == Axis.Z ? Vec3.Y : Vec3.Z;
        List<Segment> pieces = new ArrayList<>();
        for (int i = 0; i < PIECES; i++) {
            pieces.addAll(view.line(onRing(u, v, i), onRing(u, v, i + 1)));
        }
        return pieces;
    }

    private Vec3 onRing(Vec3 u, Vec3 v, int piece) {
        double angle = 2 * Math.PI * piece / PIECES;
        return middle.plus(u.times(Math.cos(angle) * LENGTH / scale)).plus(v.times(Math.sin(angle) * LENGTH / scale));
    }

    Mode mode() {
        return mode;
    }

    Vec3 middle() {
        return middle;
    }

    /** Pixels per scene unit at the middle. */
    double scale() {
        return scale;
    }

    /** What is at a point of the picture: one axis; none for what is in the middle. Nothing if nothing is there. */
    Optional<Optional<Axis>> at(double x, double y) {
        if (mode != Mode.TURN && place.distance(x, y) <= MIDDLE) {
            return Optional.of(Optional.empty());
        }
        Optional<Axis> best = Optional.empty();
        double nearest = REACH;
        for (Axis axis : Axis.values()) {
            for (Segment line : lines.getOrDefault(axis, List.of())) {
                double away = distance(line, x, y);
                if (away < nearest) {
                    nearest = away;
                    best = Optional.of(axis);
                }
            }
        }
        return best.isPresent() ? Optional.of(best) : Optional.empty();
    }

    private static double distance(Segment line, double x, double y) {
        double dx = line.x2() - line.x1();
        double dy = line.y2() - line.y1();
        double length = dx * dx + dy * dy;
        double t = length == 0 ? 0 : Math.max(0, Math.min(1, ((x - line.x1()) * dx + (y - line.y1()) * dy) / length));
        return Math.hypot(x - line.x1() - t * dx, y - line.y1() - t * dy);
    }

    /** How far along an axis the mouse is; not a number if that cannot be said. */
    double along(Axis axis, double x, double y) {
        List<Vec3> ray = view.ray(x, y, 1);
        if (ray.isEmpty()) {
            return Double.NaN;
        }
        // @source the points of two lines that are nearest to each other
        Vec3 way = axis.times(1);
        Vec3 look = ray.get(1).minus(ray.get(0)).normalized();
        Vec3 from = middle.minus(ray.get(0));
        double both = way.dot(look);
        double apart = 1 - both * both;
        return apart < 1e-6 ? Double.NaN : (both * look.dot(from) - way.dot(from)) / apart;
    }

    /** Where the mouse is at the height of the middle, from there; empty where the floor is not seen. */
    Optional<Vec3> onFloor(double x, double y) {
        List<Vec3> ray = view.ray(x, y, 1);
        if (ray.isEmpty()) {
            return Optional.empty();
        }
        Vec3 look = ray.get(1).minus(ray.get(0)).normalized();
        double distance = (middle.y() - ray.get(0).y()) / look.y();
        return Math.abs(look.y()) < 0.01 || !(distance > 0) ? Optional.empty() : Optional.of(ray.get(0).plus(look.times(distance)).minus(middle));
    }

    /** Degrees about an axis from one place of the mouse to another. */
    double turned(Axis axis, double x0, double y0, double x, double y) {
        double turned = Math.toDegrees(Math.atan2(place.getY() - y, x - place.getX()) - Math.atan2(place.getY() - y0, x0 - place.getX()));
        return Math.IEEEremainder(axis.of(eye.minus(middle)) >= 0 ? turned : -turned, 360);
    }

    /** By what something grows that is pulled from one place to another. */
    double factor(Optional<Axis> axis, double x0, double y0, double x, double y) {
        if (axis.isEmpty()) {
            return Math.max(0.01, 1 + (x - x0 - (y - y0)) / LENGTH);
        }
        double before = along(axis.get(), x0, y0);
        double now = along(axis.get(), x, y);
        return Double.isNaN(before) || Double.isNaN(now) || Math.abs(before) < 1e-9 ? 1 : Math.max(0.01, now / before);
    }

    /** Where they are drawn. */
    void measure(Extent extent) {
        extent.with(place.getX(), place.getY());
        lines.values().forEach(extent::with);
    }

    /** @param held which of them is held or under the mouse */
    void draw(GraphicsContext g, Optional<Optional<Axis>> held) {
        g.setLineDashes();
        for (Axis axis : Axis.values()) {
            List<Segment> own = lines.getOrDefault(axis, List.of());
            stroke(g, own, Color.BLACK, 5);
            Color color = held.equals(Optional.of(Optional.of(axis))) ? HELD : color(axis);
            stroke(g, own, color, 2.5);
            if (mode != Mode.TURN && !own.isEmpty()) {
                Segment last = own.get(own.size() - 1);
                end(g, last, color, axis);
            }
        }
        if (mode != Mode.TURN) {
            g.setFill(held.equals(Optional.of(Optional.empty())) ? HELD : Color.WHITE);
            g.setStroke(Color.BLACK);
            g.setLineWidth(1.5);
            if (mode == Mode.MOVE) {
                g.fillOval(place.getX() - 5, place.getY() - 5, 10, 10);
                g.strokeOval(place.getX() - 5, place.getY() - 5, 10, 10);
            } else {
                g.fillRect(place.getX() - 5, place.getY() - 5, 10, 10);
                g.strokeRect(place.getX() - 5, place.getY() - 5, 10, 10);
            }
        }
    }

    private static Color color(Axis axis) {
        return switch (axis) {
            case X -> Color.web("#f85149");
            case Y -> Color.web("#3fb950");
            case Z -> Color.web("#58a6ff");
        };
    }

    private static void stroke(GraphicsContext g, List<Segment> pieces, Color color, double width) {
        g.setStroke(color);
        g.setLineWidth(width);
        pieces.forEach(piece -> g.strokeLine(piece.x1(), piece.y1(), piece.x2(), piece.y2()));
    }

    private void end(GraphicsContext g, Segment line, Color color, Axis axis) {
        double x = line.x2();
        double y = line.y2();
        double length = Math.max(1e-9, line.length());
        double dx = (x - line.x1()) / length;
        double dy = (y - line.y1()) / length;
        g.setFill(color);
        if (mode == Mode.SCALE) {
            g.fillRect(x - 5, y - 5, 10, 10);
        } else if (line.length() > 8) {
            g.fillPolygon(new double[] {x + 10 * dx, x - 5 * dy, x + 5 * dy}, new double[] {y + 10 * dy, y + 5 * dx, y - 5 * dx}, 3);
        }
        Plates.letter(g, axis.name().toLowerCase(Locale.ROOT), x + 18 * dx, y + 18 * dy, color);
    }
}
