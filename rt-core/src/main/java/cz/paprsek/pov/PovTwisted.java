package cz.paprsek.pov;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Extrude;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.shape.outline.Lathed;
import cz.paprsek.shape.outline.Outline;
import java.util.ArrayList;
import java.util.List;

/** Twisted extrudes, which POV-Ray has none of, as meshes: their sides cut both ways so finely that none is seen to be flat, with the normals of the body. */
final class PovTwisted {
    /** How far the middle of two triangles may be from the body, as a share of its radius. */
    private static final double FINENESS = 1.0 / 2000;
    /** By how much a slice may be turned against the one below, in radians: then edges between them are as near. */
    private static final double STEP = Math.toRadians(3);
    private static final int MOST_SIDES = 100_000;
    /** Edges that are bent by less are those of a curve. */
    private static final double SMOOTH = StrictMath.cos(Math.toRadians(20));

    private final Extrude extrude;
    private final Outline outline;
    private final double twist;
    private final Triangles.Builder builder = Triangles.builder();
    private final List<Float> normals = new ArrayList<>();
    /** Places and normals in the outline, each the foot of a column of vertices. */
    private final List<Vec3> feet = new ArrayList<>();
    private final List<Vec3> footNormals = new ArrayList<>();
    /** From one column to another. */
    private final List<int[]> sides = new ArrayList<>();
    private int vertices;

    private PovTwisted(Extrude extrude) {
        this.extrude = extrude;
        outline = Outline.of("extrude", extrude.path(), extrude.points());
        twist = Math.toRadians(extrude.twist());
    }

    /** The triangles of one. */
    static Triangles of(Extrude extrude) {
        return new PovTwisted(extrude).triangles();
    }

    /** By up to which share of its radius a mesh is off; of many turns its slices are thicker, and it is off by more. */
    static double error(Extrude extrude) {
        PovTwisted twisted = new PovTwisted(extrude);
        Cuts cuts = twisted.cuts(twisted.outline.polygons(Lathed.tolerance(twisted.outline)));
        return FINENESS * cuts.coarser * cuts.coarser;
    }

    /**
     * How the sides are cut.
     *
     * @param step between slices, radians, and width, in units of the outline, if there need not be too many
     * @param coarser what both are multiplied by, since there would be
     */
    private record Cuts(double step, double width, double coarser) {}

    private Cuts cuts(List<List<Vec3>> polygons) {
        double around = 0;
        double radius = 0;
        for (List<Vec3> polygon : polygons) {
            for (int i = 0; i + 1 < polygon.size(); i++) {
                around += polygon.get(i + 1).minus(polygon.get(i)).length();
                radius = Math.max(radius, polygon.get(i).length());
            }
        }
        // Two triangles between slices are off by a quarter of their width times the turn.
        double step = Math.min(STEP, Math.abs(twist));
        double width = 4 * FINENESS * radius / step;
        return new Cuts(step, width, Math.max(1, Math.sqrt(around / width * Math.abs(twist) / step / MOST_SIDES)));
    }

    private Triangles triangles() {
        List<List<Vec3>> polygons = outline.polygons(Lathed.tolerance(outline));
        Cuts cuts = cuts(polygons);
        int slices = (int) Math.ceil(Math.abs(twist) / cuts.step / cuts.coarser);
        for (List<Vec3> polygon : polygons) {
            contour(corners(polygon), cuts.width * cuts.coarser);
        }
        for (int column = 0; column < feet.size(); column++) {
            for (int slice = 0; slice <= slices; slice++) {
                vertex(feet.get(column), footNormals.get(column), (double) slice / slices);
            }
        }
        for (int[] side : sides) {
            int left = side[0] * (slices + 1);
            int right = side[1] * (slices + 1);
            for (int slice = 0; slice < slices; slice++) {
                builder.triangle(left + slice, right + slice, right + slice + 1);
                if (slice + 1 < slices || extrude.taper() > 0) {
                    builder.triangle(left + slice, right + slice + 1, left + slice + 1);
                }
            }
        }
        PovFlats flats = new PovFlats(polygons);
        flats.triangles((a, b, c) -> end(a, c, b, 0));
        if (extrude.taper() > 0) {
            flats.triangles((a, b, c) -> end(a, b, c, 1));
        }
        float[] all = new float[normals.size()];
        for (int i = 0; i < all.length; i++) {
            all[i] = normals.get(i);
        }
        return builder.build().withNormals(all);
    }

    private static List<Vec3> corners(List<Vec3> closed) {
        List<Vec3> corners = new ArrayList<>();
        for (Vec3 corner : closed.subList(1, closed.size())) {
            if (corners.isEmpty() || !corner.equals(corners.get(corners.size() - 1))) {
                corners.add(corner);
            }
        }
        if (corners.size() > 1 && corners.get(0).equals(corners.get(corners.size() - 1))) {
            corners.remove(corners.size() - 1);
        }
        return corners;
    }

    /** Columns along a contour: at a sharp corner two. */
    private void contour(List<Vec3> corners, double width) {
        int n = corners.size();
        int last = -1;
        int first = -1;
        for (int i = 0; i < n && n > 1; i++) {
            Vec3 from = corners.get(i);
            Vec3 to = corners.get((i + 1) % n);
            Vec3 start = normal(corners, i, i);
            Vec3 end = normal(corners, i + 1, i);
            int left = last >= 0 && isSmooth(corners, i) ? last : column(from, start);
            first = i == 0 ? left : first;
            int parts = (int) Math.max(1, Math.ceil(to.minus(from).length() / width));
            for (int k = 1; k <= parts; k++) {
                double share = (double) k / parts;
                int right = k < parts ? column(mixed(from, to, share), mixed(start, end, share)) : i == n - 1 && isSmooth(corners, 0) ? first : column(to, end);
                sides.add(new int[] {left, right});
                left = right;
            }
            last = left;
        }
    }

    private int column(Vec3 foot, Vec3 normal) {
        feet.add(foot);
        footNormals.add(normal);
        return feet.size() - 1;
    }

    private static Vec3 mixed(Vec3 from, Vec3 to, double share) {
        return from.times(1 - share).plus(to.times(share));
    }

    /** Across the edge that begins at a corner. */
    private static Vec3 across(List<Vec3> corners, int i) {
        int n = corners.size();
        Vec3 along = corners.get((i + 1) % n).minus(corners.get(i % n)).normalized();
        return new Vec3(along.y(), -along.x(), 0);
    }

    private static boolean isSmooth(List<Vec3> corners, int i) {
        return across(corners, i + corners.size() - 1).dot(across(corners, i)) >= SMOOTH;
    }

    /** At a corner, of an edge that begins or ends there. */
    private static Vec3 normal(List<Vec3> corners, int corner, int edge) {
        return isSmooth(corners, corner) ? across(corners, corner + corners.size() - 1).plus(across(corners, corner)).normalized() : across(corners, edge);
    }

    /** As {@link cz.paprsek.shape.outline.Extruded#describe} has the normal. */
    private void vertex(Vec3 foot, Vec3 normal, double share) {
        double growth = (extrude.taper() - 1) / extrude.height();
        double size = 1 + (extrude.taper() - 1) * share;
        double nz = -size * twist / extrude.height() * (normal.y() * foot.x() - normal.x() * foot.y()) - growth * (normal.x() * foot.x() + normal.y() * foot.y());
        vertex(foot, share, turned(normal, share).plus(new Vec3(0, 0, nz)));
    }

    private void vertex(Vec3 foot, double share, Vec3 normal) {
        double size = 1 + (extrude.taper() - 1) * share;
        Vec3 at = turned(foot, share).times(size);
        builder.vertex(at.x(), at.y(), share * extrude.height());
        Vec3 unit = normal.normalized();
        normals.add((float) unit.x());
        normals.add((float) unit.y());
        normals.add((float) unit.z());
        vertices++;
    }

    private Vec3 turned(Vec3 p, double share) {
        double cos = StrictMath.cos(twist * share);
        double sin = StrictMath.sin(twist * share);
        return new Vec3(p.x() * cos - p.y() * sin, p.x() * sin + p.y() * cos, 0);
    }

    private void end(Vec3 a, Vec3 b, Vec3 c, double share) {
        Vec3 normal = new Vec3(0, 0, share > 0 ? 1 : -1);
        vertex(a, share, normal);
        vertex(b, share, normal);
        vertex(c, share, normal);
        builder.triangle(vertices - 3, vertices - 2, vertices - 1);
    }
}
