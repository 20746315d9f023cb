package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.outline.Extruded;
import cz.paprsek.shape.outline.Outline;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * An outline in the plane z = 0 made thick, up to z = height. Contours within contours are holes, by the even-odd rule. Straight lines, arcs and Bézier
 * curves are met exactly; twisted, only what a ray cuts off an edge can be lost, 1/3000 of the radius deep.
 *
 * @param path as SVG has it, but with y up; empty if there are points
 * @param points corners, x and y in turn; empty if there is a path
 * @param twist by how many degrees the other end is turned, from +x to +y
 * @param taper how large the other end is; 0 for a point
 */
@Element("An outline in the plane z = 0 made thick, from there towards +z.")
public record Extrude(
        @Attribute(value = Kind.PATH, means = "The outline as path data of SVG, with y up; contours within others are holes", otherwise = Attribute.NOTHING) String path,
        @Attribute(value = Kind.POINTS, means = "The outline's corners instead, x and y of each", otherwise = Attribute.NOTHING,
                example = "-0.5 -0.4 0.5 -0.4 0 0.5") String points,
        @Attribute(value = Kind.POSITIVE, means = "Above 0", example = "0.5") double height,
        @Attribute(value = Kind.TWIST, means = "By how many degrees the other end is turned, from +x to +y", otherwise = "0") double twist,
        @Attribute(value = Kind.NOT_NEGATIVE, means = "How large the other end is, compared with the outline; 0 for a point", otherwise = "1") double taper) implements Solid {
    /** The largest twist there may be, either way, in degrees. */
    public static final double MOST_TWIST = Kind.TWIST.most();
    private static final double SLICE = 15;
    private static final int MOST_SLICES = 48;

    public Extrude {
        Objects.requireNonNull(path, "path");
        Objects.requireNonNull(points, "points");
        Require.size("extrude height", height);
        Require.within("extrude twist", twist, Kind.TWIST.least(), Kind.TWIST.most());
        Require.sizeOrZero("extrude taper", taper);
        Outline.of("extrude", path, points);
    }

    private Outline outline() {
        return Outline.of("extrude", path, points);
    }

    @Override
    public Face face(int number) {
        return number >= Extruded.FIRST_SIDE ? Face.SIDE : number == Extruded.BOTTOM ? Face.MINUS_Z : Face.PLUS_Z;
    }

    @Override
    public Bounds bounds() {
        return bounds(outline());
    }

    private Bounds bounds(Outline outline) {
        double large = Math.max(1, taper);
        double x = Math.max(Math.abs(outline.minX()), Math.abs(outline.maxX()));
        double y = Math.max(Math.abs(outline.minY()), Math.abs(outline.maxY()));
        double around = large * Math.sqrt(x * x + y * y);
        return twist != 0 ? new Bounds(-around, -around, 0, around, around, height)
                : new Bounds(Math.min(outline.minX(), taper * outline.minX()), Math.min(outline.minY(), taper * outline.minY()), 0,
                        Math.max(outline.maxX(), taper * outline.maxX()), Math.max(outline.maxY(), taper * outline.maxY()), height);
    }

    /** Both ends, with slices between if it is twisted, and edges from one to the other. */
    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        Outline outline = outline();
        double tolerance = Math.max(outline.maxX() - outline.minX(), outline.maxY() - outline.minY()) / 20 / steps;
        int slices = (int) Math.max(1, Math.min(MOST_SLICES, Math.ceil(Math.abs(twist) / SLICE)));
        List<Curve> curves = new ArrayList<>();
        for (List<Vec3> polygon : outline.polygons(tolerance)) {
            for (int i = 0; i <= slices; i++) {
                double share = (double) i / slices;
                if (i < slices || taper > 0) {
                    curves.add(new Curve(polygon.stream().map(p -> at(p, share)).toList()));
                }
            }
            int each = Math.max(1, polygon.size() / 32);
            for (int i = 0; i + 1 < polygon.size(); i += each) {
                Vec3 corner = polygon.get(i);
                List<Vec3> edge = new ArrayList<>();
                for (int k = 0; k <= 4 * slices; k++) {
                    if (twist != 0 || k % (4 * slices) == 0) {
                        edge.add(at(corner, k / 4.0 / slices));
                    }
                }
                curves.add(new Curve(edge));
            }
        }
        return curves;
    }

    private Vec3 at(Vec3 p, double share) {
        double size = 1 + (taper - 1) * share;
        double angle = twist * share * Math.PI / 180;
        double cos = twist == 0 ? 1 : StrictMath.cos(angle);
        double sin = twist == 0 ? 0 : StrictMath.sin(angle);
        return new Vec3(size * (p.x() * cos - p.y() * sin), size * (p.x() * sin + p.y() * cos), share * height);
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        Outline outline = outline();
        return parts.add(part -> new Extruded(part, toWorld, bounds(outline), outline, height, twist, taper));
    }
}
