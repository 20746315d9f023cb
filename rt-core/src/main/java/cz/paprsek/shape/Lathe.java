package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.outline.Lathed;
import cz.paprsek.shape.outline.Outline;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;
import cz.paprsek.text.Numbers;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * An outline turned about the y axis: x is the distance from the axis. Straight lines make cones, met exactly; curves are cut into straight pieces,
 * 1/50 000 of the outline's size from them at most, with the curve's normals.
 *
 * @param path as SVG has it, but with y up; empty if there are points
 * @param points corners, x and y in turn; empty if there is a path
 * @param angle how far it is turned, in degrees, from +x towards −z
 */
@Element("An outline turned about its y axis, as on a lathe.")
public record Lathe(
        @Attribute(value = Kind.PATH, means = "The outline as path data of SVG, with y up, nowhere left of the axis", otherwise = Attribute.NOTHING) String path,
        @Attribute(value = Kind.POINTS, means = "The outline's corners instead, x and y of each", otherwise = Attribute.NOTHING,
                example = "0 0 0.5 0 0.2 0.3 0.3 1 0 1") String points,
        @Attribute(value = Kind.TURN, means = "How far it is turned, in degrees, from +x towards -z", otherwise = "360") double angle) implements Solid {
    private static final int MOST_RIMS = 24;

    public Lathe {
        Objects.requireNonNull(path, "path");
        Objects.requireNonNull(points, "points");
        Require.that(angle > 0 && angle <= Kind.TURN.most(), "lathe angle must be " + Kind.TURN.words() + ", but is " + Numbers.text(angle));
        Outline outline = Outline.of("lathe", path, points);
        Require.that(outline.minX() >= 0, "lathe " + (path.isBlank() ? "points" : "path") + " must not reach beyond the axis, x = 0, but its least x is " + Numbers.text(outline.minX()));
    }

    private Outline outline() {
        return Outline.of("lathe", path, points);
    }

    @Override
    public Face face(int number) {
        return Face.ONLY;
    }

    @Override
    public Bounds bounds() {
        return bounds(outline());
    }

    private static Bounds bounds(Outline outline) {
        return new Bounds(-outline.maxX(), outline.minY(), -outline.maxX(), outline.maxX(), outline.maxY(), outline.maxX());
    }

    /** Its rims, and the outline at either side. */
    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        Outline outline = outline();
        List<Curve> curves = new ArrayList<>();
        double towards = StrictMath.atan2(-along.z(), along.x());
        for (List<Vec3> polygon : outline.polygons(Lathed.tolerance(outline) * 20)) {
            int each = Math.max(1, polygon.size() / MOST_RIMS);
            for (int i = 0; i + 1 < polygon.size(); i++) {
                Vec3 corner = polygon.get(i);
                boolean isWidest = corner.x() == outline.maxX() || corner.y() == outline.minY() || corner.y() == outline.maxY();
                if (corner.x() > 0 && (i % each == 0 || isWidest)) {
                    curves.add(rim(corner, steps));
                }
            }
            if (angle == 360) {
                curves.add(section(polygon, towards + Math.PI / 2));
                curves.add(section(polygon, towards - Math.PI / 2));
            } else {
                curves.add(section(polygon, 0));
                curves.add(section(polygon, angle * Math.PI / 180));
            }
        }
        return curves;
    }

    private Curve rim(Vec3 corner, int steps) {
        List<Vec3> points = new ArrayList<>();
        for (int i = 0; i <= steps; i++) {
            points.add(turned(corner, i * angle / steps * Math.PI / 180));
        }
        return new Curve(points);
    }

    private static Curve section(List<Vec3> polygon, double turn) {
        return new Curve(polygon.stream().map(p -> turned(p, turn)).toList());
    }

    private static Vec3 turned(Vec3 p, double turn) {
        return new Vec3(p.x() * StrictMath.cos(turn), p.y(), -p.x() * StrictMath.sin(turn));
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        Outline outline = outline();
        return parts.add(part -> new Lathed(part, toWorld, bounds(outline), outline, angle));
    }
}
