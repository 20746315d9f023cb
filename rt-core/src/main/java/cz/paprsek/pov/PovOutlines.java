package cz.paprsek.pov;

import static cz.paprsek.text.Numbers.text;

import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Extrude;
import cz.paprsek.shape.Lathe;
import cz.paprsek.shape.Text;
import cz.paprsek.shape.outline.Lathed;
import cz.paprsek.shape.outline.Outline;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

/** Solids of outlines in POV-Ray's words, curves as Bézier curves. */
final class PovOutlines {
    private static final int LINES = 200;
    private static final int STEPS = 8;

    private PovOutlines() {}

    /** POV-Ray sweeps along y what lies in x and z, or towards the origin what lies at y = 1; it turns nothing meanwhile. */
    static String extrude(Extrude extrude) {
        if (extrude.twist() != 0) {
            return PovMesh.enclosing(PovTwisted.of(extrude));
        }
        Outline outline = Outline.of("extrude", extrude.path(), extrude.points());
        boolean areCurves = !outline.isStraight();
        // Of straight pieces, the corners.
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

    /** Whether letters, or parts of one, lie over each other, so that there are holes; seen along lines across the letters. */
    static boolean areOver(Text text) {
        List<Vec3> curves = text.curves();
        double low = curves.stream().mapToDouble(Vec3::y).min().orElse(0);
        double high = curves.stream().mapToDouble(Vec3::y).max().orElse(0);
        double slack = 1e-6 * text.size();
        List<List<Vec3>> lines = inLines(curves);
        for (int line = 0; line < LINES; line++) {
            // From left to right, where an outline goes up or down across it.
            List<double[]> met = crossings(lines, low + (high - low) * (line + 0.5) / LINES);
            met.sort(Comparator.comparingDouble(one -> one[0]));
            int around = 0;
            for (int i = 0; i + 1 < met.size(); i++) {
                around += (int) met.get(i)[1];
                if (around != 0 && around % 2 == 0 && met.get(i + 1)[0] - met.get(i)[0] > slack) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Each Bézier curve in straight pieces, from point to point. */
    private static List<List<Vec3>> inLines(List<Vec3> curves) {
        List<List<Vec3>> lines = new ArrayList<>();
        for (int i = 0; i < curves.size(); i += 4) {
            List<Vec3> four = curves.subList(i, i + 4);
            List<Vec3> points = new ArrayList<>(List.of(four.get(0)));
            for (int k = 1; k <= STEPS; k++) {
                points.add(at(four, (double) k / STEPS));
            }
            lines.add(points);
        }
        return lines;
    }

    /** Where straight pieces are crossed: x, and 1 upwards or -1 downwards. */
    private static List<double[]> crossings(List<List<Vec3>> lines, double y) {
        List<double[]> met = new ArrayList<>();
        for (List<Vec3> points : lines) {
            Vec3 from = points.get(0);
            for (Vec3 to : points.subList(1, points.size())) {
                if ((from.y() > y) != (to.y() > y)) {
                    met.add(new double[] {from.x() + (to.x() - from.x()) * (y - from.y()) / (to.y() - from.y()), to.y() > y ? 1 : -1});
                }
                from = to;
            }
        }
        return met;
    }

    private static Vec3 at(List<Vec3> four, double t) {
        double s = 1 - t;
        return four.get(0).times(s * s * s).plus(four.get(1).times(3 * s * s * t)).plus(four.get(2).times(3 * s * t * t)).plus(four.get(3).times(t * t * t));
    }

    static String lathe(Lathe lathe) {
        Outline outline = Outline.of("lathe", lathe.path(), lathe.points());
        List<List<Vec3>> polygons = outline.polygons(Lathed.tolerance(outline));
        if (polygons.size() > 1) {
            throw new IllegalArgumentException("a scene for POV-Ray cannot hold a lathe of " + polygons.size() + " contours: there it has one");
        }
        List<Vec3> points = outline.isStraight() ? polygons.get(0) : outline.curves();
        String whole = "lathe { " + (outline.isStraight() ? "linear" : "bezier") + "_spline " + points.size() + ", " + points(points) + " sturm";
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
