package cz.paprsek.pov;

import static cz.paprsek.text.Numbers.text;

import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Extrude;
import cz.paprsek.shape.Lathe;
import cz.paprsek.shape.Text;
import cz.paprsek.shape.outline.Lathed;
import cz.paprsek.shape.outline.Outline;
import java.util.List;
import java.util.stream.Collectors;

/** Solids of outlines in POV-Ray's words: Bézier curves as such where POV-Ray makes them thick, all other curves in straight pieces. */
final class PovOutlines {
    private PovOutlines() {}

    /** POV-Ray sweeps along y what lies in x and z, or towards the origin what lies at y = 1. */
    static String extrude(Extrude extrude) {
        if (extrude.twist() != 0) {
            throw new IllegalArgumentException("a scene for POV-Ray cannot hold a twisted extrude: POV-Ray has none");
        }
        Outline outline = Outline.of("extrude", extrude.path(), extrude.points());
        boolean areCurves = !outline.isStraight() && !outline.curves().isEmpty();
        List<Vec3> points = areCurves ? outline.curves() : outline.polygons(Lathed.tolerance(outline)).stream().flatMap(List::stream).toList();
        double taper = extrude.taper();
        String spline = areCurves ? "bezier_spline " : "linear_spline ";
        String sweep = taper == 1 ? "linear_sweep " + spline + "0, " + text(extrude.height())
                : "conic_sweep " + spline + text(Math.min(1, taper)) + ", " + text(Math.max(1, taper));
        // From the height in the cone to z: 1 is at z = 0, the taper at the other end.
        double stretch = taper == 1 ? 1 : extrude.height() / (taper - 1);
        return "prism { " + sweep + ", " + points.size() + ", " + points(points)
                + " matrix <1, 0, 0, 0, 0, " + text(stretch) + ", 0, 1, 0, 0, 0, " + text(taper == 1 ? 0 : -stretch) + ">";
    }

    /** Letters that lie over each other have holes there. */
    static String letters(Text text) {
        Require.that(text.isRead(), "a scene for POV-Ray needs the letters of a text, but the font \"" + text.font() + "\" has not been read");
        return "prism { linear_sweep bezier_spline 0, " + text(text.depth()) + ", " + text.curves().size() + ", " + points(text.curves())
                + " matrix <1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0>";
    }

    static String lathe(Lathe lathe) {
        Outline outline = Outline.of("lathe", lathe.path(), lathe.points());
        List<List<Vec3>> polygons = outline.polygons(Lathed.tolerance(outline));
        if (polygons.size() > 1) {
            throw new IllegalArgumentException("a scene for POV-Ray cannot hold a lathe of " + polygons.size() + " contours: there it has one");
        }
        String whole = "lathe { linear_spline " + polygons.get(0).size() + ", " + points(polygons.get(0)) + " sturm";
        if (lathe.angle() == 360) {
            return whole;
        }
        double angle = lathe.angle() * Math.PI / 180;
        String start = "plane { z, 0 }";
        String end = "plane { <" + text(-StrictMath.sin(angle)) + ", 0, " + text(-StrictMath.cos(angle)) + ">, 0 }";
        return lathe.angle() <= 180 ? "intersection { " + whole + " } " + start + " " + end
                : "difference { " + whole + " } intersection { " + start.replace(" }", " inverse }") + " " + end.replace(" }", " inverse }") + " }";
    }

    private static String points(List<Vec3> points) {
        return points.stream().map(p -> "<" + text(p.x()) + ", " + text(p.y()) + ">").collect(Collectors.joining(", "));
    }
}
