package cz.paprsek.shape.mesh;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Search;
import cz.paprsek.tree.Sieve;
import java.util.Arrays;

/**
 * Scratch of a ray: looks for the triangles that its line crosses, in the space of a mesh.
 *
 * <p>Space is sheared so that the line becomes the z axis; then a triangle is crossed if the origin lies on the same side of all its sides. Two
 * triangles with a common side work that out from the same numbers, with opposite signs, so that a line never slips between them. If it passes
 * right through a side or corner, it counts as moved aside by an infinitely small step, always the same one: of triangles around a corner it
 * crosses exactly those that the moved line would, so that it enters what is closed as often as it leaves.
 *
 * @source Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013; Edelsbrunner, Mücke, Simulation of Simplicity, ACM TOG 9(1), 1990
 */
final class MeshSearch extends Search<Ray> {
    /** The sides from which triangles are met, as bits. */
    static final int FRONT = 1;
    static final int BACK = 2;
    static final int BOTH = FRONT | BACK;

    /** No triangle. */
    private static final int NONE = Integer.MAX_VALUE;

    private Facets facets;
    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;
    /** Reciprocal direction, always finite. */
    private double rx;
    private double ry;
    private double rz;
    /** Which axes become x, y and z, the last the one along which the line goes fastest; where it starts along them, and the shear. */
    private int kx;
    private int ky;
    private int kz;
    private double atX;
    private double atY;
    private double atZ;
    private double shearX;
    private double shearY;
    private double shearZ;
    /** The stretch of the line within the mesh's box: the tree counts t from its beginning. */
    private double begin;
    private double end;

    /** What is looked for: all crossings, or the nearest. */
    private boolean all;
    /** Between which t crossings count, and from which sides; those at most so far from 0 do not if they are of a side that is passed over. */
    private double above;
    private double below;
    private int sides;
    private double near;
    private int passed;
    /** Twice the area, as the line sees it, of the triangle that was crossed last: above 0 if it was met from in front. */
    private double crossed;
    /** The nearest one: of those in one place that of the lowest triangle. */
    private double best;
    private int bestNumber;
    private int bestPlace;
    private boolean bestFront;

    /** All, with the numbers of triangles, complemented if met from behind. */
    private double[] t = new double[16];
    private int[] number = new int[16];
    private int count;

    MeshSearch(Facets facets) {
        this.facets = facets;
    }

    /** Takes over a line; whether it meets the box of the mesh. */
    boolean start(Facets mesh, Affine toLocal, Ray ray) {
        if (facets != mesh) {
            facets = mesh;
        }
        Line line = ray.in(toLocal);
        ox = line.ox;
        oy = line.oy;
        oz = line.oz;
        dx = line.dx;
        dy = line.dy;
        dz = line.dz;
        rx = reciprocal(dx);
        ry = reciprocal(dy);
        rz = reciprocal(dz);
        Bounds box = mesh.box;
        begin = Double.NEGATIVE_INFINITY;
        end = Double.POSITIVE_INFINITY;
        clip(box.minX(), box.maxX(), ox, rx);
        clip(box.minY(), box.maxY(), oy, ry);
        clip(box.minZ(), box.maxZ(), oz, rz);
        return begin <= end;
    }

    private void clip(double low, double high, double o, double r) {
        double first = ((r < 0 ? high : low) - o) * r;
        double last = ((r < 0 ? low : high) - o) * r;
        begin = first > begin ? first : begin;
        end = last < end ? last : end;
    }

    /** A crossing within {@code near} of t = 0, of one of the {@code passed} sides, is where the ray starts, and none. */
    private boolean limit(double from, double to, int fromSides, double nearStart, int passedSides) {
        above = from;
        below = to;
        sides = fromSides;
        near = nearStart;
        passed = passedSides;
        double slack = 1e-9 * (Math.abs(begin) + Math.abs(end));
        begin = Math.max(begin - slack, from);
        end = Math.min(end + slack, to);
        return begin <= end;
    }

    /** Whether there is a crossing between two values of t; the nearest is known then. */
    boolean nearest(Ray ray, double from, double to, int fromSides, double nearStart, int passedSides) {
        best = Double.POSITIVE_INFINITY;
        bestNumber = NONE;
        all = false;
        if (!limit(from, to, fromSides, nearStart, passedSides)) {
            return false;
        }
        shear();
        facets.tree.nearest(this, ray, facets.tree.whole(), end - begin);
        return bestNumber != NONE;
    }

    /** Whether there is any crossing between two values of t. */
    boolean any(Ray ray, double from, double to, int fromSides) {
        best = Double.POSITIVE_INFINITY;
        bestNumber = NONE;
        all = false;
        if (!limit(from, to, fromSides, 0, 0)) {
            return false;
        }
        shear();
        return facets.tree.any(this, ray, facets.tree.whole());
    }

    /** Gathers all crossings between two values of t, in order: where they are in one place, those that enter first, then the lower triangles. */
    void gather(Ray ray, double from, double to, double nearStart, int passedSides) {
        count = 0;
        all = true;
        if (limit(from, to, BOTH, nearStart, passedSides)) {
            shear();
            facets.tree.any(this, ray, facets.tree.whole());
            sort();
        }
    }

    double nearestT() {
        return best;
    }

    int nearestNumber() {
        return bestNumber;
    }

    /** Its place in the order of the leaves. */
    int nearestPlace() {
        return bestPlace;
    }

    /** Whether it is met from in front: its normal is towards the start of the line. */
    boolean nearestIsFront() {
        return bestFront;
    }

    int size() {
        return count;
    }

    double t(int i) {
        return t[i];
    }

    /** The triangle of a crossing, and whether it is met from in front. */
    int number(int i) {
        return number[i] < 0 ? ~number[i] : number[i];
    }

    boolean isFront(int i) {
        return number[i] >= 0;
    }

    private void shear() {
        double x = Math.abs(dx);
        double y = Math.abs(dy);
        double z = Math.abs(dz);
        kz = x > y ? x > z ? 0 : 2 : y > z ? 1 : 2;
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        double along = axis(kz, dx, dy, dz);
        if (along < 0) {
            int other = kx;
            kx = ky;
            ky = other;
        }
        atX = axis(kx, ox, oy, oz);
        atY = axis(ky, ox, oy, oz);
        atZ = axis(kz, ox, oy, oz);
        shearX = axis(kx, dx, dy, dz) / along;
        shearY = axis(ky, dx, dy, dz) / along;
        shearZ = 1 / along;
    }

    private static double axis(int k, double x, double y, double z) {
        return k == 0 ? x : k == 1 ? y : z;
    }

    @Override
    protected void aim(Ray ray) {
        along(ox + begin * dx, oy + begin * dy, oz + begin * dz, rx, ry, rz, 0, end - begin);
    }

    private static double reciprocal(double d) {
        double r = 1 / d;
        return Math.abs(r) <= Double.MAX_VALUE ? r : Math.copySign(Double.MAX_VALUE, d);
    }

    @Override
    protected double meet(Ray ray, int first, int last) {
        cross(first, last);
        return Math.min(best, end) - begin;
    }

    @Override
    protected boolean stopsAt(Ray ray, int first, int last) {
        cross(first, last);
        return !all && bestNumber != NONE;
    }

    /** Notes where the line crosses triangles, by their places in the tree. What is known of the line is handed on: fields would be read for each triangle, which takes a sixth longer. */
    private void cross(int first, int last) {
        float[] own = facets.own;
        int[] corners = facets.corners;
        double[] at = facets.places;
        int x = kx;
        int y = ky;
        int z = kz;
        double sx = shearX;
        double sy = shearY;
        double px = atX;
        double py = atY;
        double pz = atZ;
        if (own.length > 0) {
            int ofX = 3 * x;
            int ofY = 3 * y;
            int ofZ = 3 * z;
            Sieve sieve = facets.sieve;
            for (int i = sieve.next(own, first, last, ofX, ofY, ofZ, px, py, pz, sx, sy); i < last; i = sieve.next(own, i + 1, last, ofX, ofY, ofZ, px, py, pz, sx, sy)) {
                int atX = Sieve.EACH * i + ofX;
                int atY = Sieve.EACH * i + ofY;
                int atZ = Sieve.EACH * i + ofZ;
                note(i, crossing(own[atX], own[atY], own[atZ], own[atX + 1], own[atY + 1], own[atZ + 1], own[atX + 2], own[atY + 2], own[atZ + 2], px, py, pz, sx, sy));
            }
            return;
        }
        for (int i = first; i < last; i++) {
            int a = corners[Facets.EACH * i];
            int b = corners[Facets.EACH * i + 1];
            int c = corners[Facets.EACH * i + 2];
            note(i, crossing(at[a + x], at[a + y], at[a + z], at[b + x], at[b + y], at[b + z], at[c + x], at[c + y], at[c + z], px, py, pz, sx, sy));
        }
    }

    /**
     * Where the line crosses a triangle, or no number. Most are passed by, which the signs of three products tell
     * at once: a branch for each of them would often be taken against expectation, and costs more than the products do.
     */
    private double crossing(double atAx, double atAy, double atAz, double atBx, double atBy, double atBz, double atCx, double atCy, double atCz,
            double px, double py, double pz, double sx, double sy) {
        double az = atAz - pz;
        double bz = atBz - pz;
        double cz = atCz - pz;
        double ax = atAx - px - sx * az;
        double ay = atAy - py - sy * az;
        double bx = atBx - px - sx * bz;
        double by = atBy - py - sy * bz;
        double cx = atCx - px - sx * cz;
        double cy = atCy - py - sy * cz;
        double u = cx * by - cy * bx;
        double v = ax * cy - ay * cx;
        double w = bx * ay - by * ax;
        if (haveSeveralSigns(u, v, w) && u != 0 && v != 0 && w != 0) {
            return Double.NaN;
        }
        if ((u == 0 || v == 0 || w == 0) && !isCrossedAside(u, v, w, ax, ay, bx, by, cx, cy)) {
            return Double.NaN;
        }
        double sum = u + v + w;
        crossed = sum;
        return (u * az + v * bz + w * cz) * shearZ / sum;
    }

    private void note(int place, double where) {
        if (where > above && where < below) {
            double t = facets.areAnyThin ? facets.within(place, where, Math.abs(crossed), ox, oy, oz, rx, ry, rz) : where;
            if (t > above && t < below) {
                note(t, place, facets.number(place), crossed > 0);
            }
        }
    }

    private static boolean haveSeveralSigns(double u, double v, double w) {
        long sign = Double.doubleToRawLongBits(u);
        return ((sign ^ Double.doubleToRawLongBits(v)) | (sign ^ Double.doubleToRawLongBits(w))) < 0;
    }

    /** Whether a line that passes through sides crosses the triangle if it is moved by an infinitely small step along x, and one much smaller along y. */
    private static boolean isCrossedAside(double u, double v, double w, double ax, double ay, double bx, double by, double cx, double cy) {
        int atU = sign(u, cy - by, bx - cx);
        int atV = sign(v, ay - cy, cx - ax);
        int atW = sign(w, by - ay, ax - bx);
        return atU != 0 && atU == atV && atU == atW;
    }

    private static int sign(double side, double alongX, double alongY) {
        double deciding = side != 0 ? side : alongX != 0 ? alongX : alongY;
        return deciding > 0 ? 1 : deciding < 0 ? -1 : 0;
    }

    private void note(double where, int place, int triangle, boolean front) {
        int side = front ? FRONT : BACK;
        if ((sides & side) == 0 || ((passed & side) != 0 && Math.abs(where) <= near)) {
            return;
        }
        if (all) {
            add(where, front ? triangle : ~triangle);
        } else if (where < best || (where == best && triangle < bestNumber)) {
            best = where;
            bestNumber = triangle;
            bestPlace = place;
            bestFront = front;
        }
    }

    private void add(double where, int triangle) {
        if (count == t.length) {
            t = Arrays.copyOf(t, 2 * count);
            number = Arrays.copyOf(number, 2 * count);
        }
        t[count] = where;
        number[count++] = triangle;
    }

    /** By gaps that shrink: mostly there are a handful, but there may be thousands. */
    private void sort() {
        int gap = 1;
        while (gap < count / 3) {
            gap = 3 * gap + 1;
        }
        for (; gap > 0; gap /= 3) {
            for (int i = gap; i < count; i++) {
                double where = t[i];
                int triangle = number[i];
                int j = i;
                for (; j >= gap && isAfter(t[j - gap], number[j - gap], where, triangle); j -= gap) {
                    t[j] = t[j - gap];
                    number[j] = number[j - gap];
                }
                t[j] = where;
                number[j] = triangle;
            }
        }
    }

    private static boolean isAfter(double t, int triangle, double other, int otherTriangle) {
        return t > other || (t == other && ((triangle < 0) == (otherTriangle < 0) ? (triangle < 0 ? ~triangle > ~otherTriangle : triangle > otherTriangle) : triangle < 0));
    }
}
