package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/**
 * How a light is drawn: its place as a mark, and lines for its size and where it shines, world space. A direction is drawn from the light on as long
 * as it is given; that of a sun ends in the origin.
 *
 * @param extent lines around what has a size
 * @param way lines along which it shines
 * @param aim what it shines at, to be grabbed
 */
record LightSketch(Vec3 place, List<List<Vec3>> extent, List<List<Vec3>> way, Optional<Vec3> aim) {
    private static final int STEPS = 48;
    /** A cone that is wider is drawn as if it were as wide as this. */
    private static final double WIDEST = 80;

    LightSketch {
        extent = List.copyOf(extent);
        way = List.copyOf(way);
    }

    static LightSketch of(Light light, Axes axes) {
        Vec3 place = LightMoves.place(light);
        if (light instanceof SpotLight spot) {
            Vec3 aim = aim(spot);
            List<List<Vec3>> lines = new ArrayList<>();
            lines.add(List.of(place, aim));
            lines.add(rim(place, aim, spot.outerAngle()));
            lines.add(rim(place, aim, spot.fullAngle()));
            Vec3 axis = aim.minus(place);
            Vec3 side = side(axis, axes).times(width(axis, spot.outerAngle()));
            lines.add(List.of(place, aim.plus(side)));
            lines.add(List.of(place, aim.minus(side)));
            return new LightSketch(place, List.of(), lines, Optional.of(aim));
        } else if (light instanceof AreaLight area) {
            Vec3 aim = place.plus(area.direction().times(size(area)));
            return new LightSketch(place, List.of(outline(area)), List.of(List.of(place, aim)), Optional.of(aim));
        } else if (light instanceof SphereLight ball) {
            return new LightSketch(place, List.of(circle(place, axes.vector(ball.radius(), 0), axes.vector(0, ball.radius()))), List.of(), Optional.empty());
        } else if (light instanceof SunLight sun) {
            return new LightSketch(place, List.of(), List.of(List.of(place, Vec3.ZERO), rim(Vec3.ZERO, place, sun.angle() / 2)), Optional.empty());
        }
        return new LightSketch(place, List.of(), List.of(), Optional.empty());
    }

    /** Draws the sign of a light at a point of a canvas. */
    static void sign(GraphicsContext g, Light light, double x, double y, Color rim) {
        g.setStroke(rim);
        g.setLineWidth(1.5);
        // The rim is of the theme and keeps a pale light apart from what is behind; within is the light's own colour.
        g.setFill(Color.color(light.color().red() / 255, light.color().green() / 255, light.color().blue() / 255));
        g.fillOval(x - 4, y - 4, 8, 8);
        g.strokeOval(x - 4, y - 4, 8, 8);
        for (int i = 0; i < 8; i++) {
            double dx = Math.cos(i * Math.PI / 4);
            double dy = Math.sin(i * Math.PI / 4);
            g.strokeLine(x + 6 * dx, y + 6 * dy, x + 9 * dx, y + 9 * dy);
        }
    }

    /** What a spot shines at. */
    static Vec3 aim(SpotLight spot) {
        return spot.aim() instanceof Camera.Target target ? target.point() : spot.position().plus(((Camera.Direction) spot.aim()).vector());
    }

    private static double size(AreaLight area) {
        return area.form() instanceof AreaLight.Size size ? Math.max(size.width(), size.height()) : 2 * ((AreaLight.Radius) area.form()).radius();
    }

    private static List<Vec3> outline(AreaLight area) {
        Affine toWorld = area.placement().toParent();
        if (area.form() instanceof AreaLight.Size size) {
            Vec3 x = toWorld.direction(Vec3.X).times(size.width() / 2);
            Vec3 y = toWorld.direction(Vec3.Y).times(size.height() / 2);
            Vec3 p = area.position();
            return List.of(p.minus(x).minus(y), p.plus(x).minus(y), p.plus(x).plus(y), p.minus(x).plus(y), p.minus(x).minus(y));
        }
        double radius = ((AreaLight.Radius) area.form()).radius();
        return circle(area.position(), toWorld.direction(Vec3.X).times(radius), toWorld.direction(Vec3.Y).times(radius));
    }

    /** Around a cone's end. */
    private static List<Vec3> rim(Vec3 from, Vec3 middle, double degrees) {
        Vec3 axis = middle.minus(from);
        Vec3 across = perpendicular(axis.normalized()).times(width(axis, degrees));
        return circle(middle, across, axis.normalized().cross(across));
    }

    /** How far a cone's rim is from the end of its axis, degrees from the middle. */
    static double width(Vec3 axis, double degrees) {
        return axis.length() * Angles.tan(Math.min(WIDEST, degrees));
    }

    /** The way from a cone's axis to its rim, of length 1: in the plane of the projection where that can be. */
    static Vec3 side(Vec3 axis, Axes axes) {
        Vec3 across = axis.cross(axes.along());
        return across.length() > 1e-9 * axis.length() ? across.normalized() : perpendicular(axis.normalized());
    }

    private static Vec3 perpendicular(Vec3 unit) {
        return unit.cross(Math.abs(unit.y()) < 0.9 ? Vec3.Y : Vec3.X).normalized();
    }

    private static List<Vec3> circle(Vec3 middle, Vec3 a, Vec3 b) {
        List<Vec3> points = new ArrayList<>();
        for (int i = 0; i <= STEPS; i++) {
            double angle = 360.0 * i / STEPS;
            points.add(middle.plus(a.times(Angles.cos(angle))).plus(b.times(Angles.sin(angle))));
        }
        return points;
    }
}
