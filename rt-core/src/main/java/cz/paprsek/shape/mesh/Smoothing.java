package cz.paprsek.shape.mesh;

import cz.paprsek.math.Vec3;
import java.util.Arrays;

/**
 * Makes normals for corners from those of the triangles around them, without those that are bent too far. Where normals differ, one vertex
 * becomes several.
 *
 * @source Max, Weights for Computing Vertex Normals from Facet Normals, Journal of Graphics Tools 4(2), 1999
 */
final class Smoothing {
    /** Around more triangles than this at one corner it is not asked how far each is bent from each other. */
    private static final int FAN = 1000;

    private final Triangles mesh;
    private final double[] at;
    private final int[] corners;
    private final double cosine;
    /** The corners at each place, side by side: those of place p from start[p] to start[p + 1] − 1. */
    private final int[] start;
    private final int[] around;
    /** For each triangle its normal, of length 1; 0 0 0 if it has none. */
    private final float[] flat;

    private Smoothing(Triangles mesh, double angleDegrees) {
        this.mesh = mesh;
        at = mesh.places();
        corners = mesh.corners();
        // A little more, so that neighbours bent by just the angle are not told apart by rounding.
        cosine = StrictMath.cos(StrictMath.toRadians(angleDegrees)) - 1e-6;
        int[] first = Weld.firsts(at);
        start = new int[first.length + 1];
        for (int vertex : corners) {
            start[first[vertex] + 1]++;
        }
        for (int p = 0; p < first.length; p++) {
            start[p + 1] += start[p];
        }
        around = new int[corners.length];
        int[] next = Arrays.copyOf(start, first.length);
        for (int i = 0; i < corners.length; i++) {
            around[next[first[corners[i]]]++] = i;
        }
        flat = new float[corners.length];
        for (int t = 0; t < corners.length / 3; t++) {
            putNormal(t);
        }
    }

    /** @param angleDegrees how far neighbours may be bent to be shown smooth, 0–180 */
    static Triangles of(Triangles mesh, double angleDegrees) {
        return new Smoothing(mesh, angleDegrees).result();
    }

    private void putNormal(int t) {
        Vec3 n = product(3 * t);
        double length = Math.sqrt(n.dot(n));
        if (length > 0) {
            flat[3 * t] = (float) (n.x() / length);
            flat[3 * t + 1] = (float) (n.y() / length);
            flat[3 * t + 2] = (float) (n.z() / length);
        }
    }

    /** The product of the sides that leave a corner. */
    private Vec3 product(int corner) {
        int t = corner / 3 * 3;
        return Measures.product(at, 3 * corners[corner], 3 * corners[t + (corner + 1 - t) % 3], 3 * corners[t + (corner + 2 - t) % 3]);
    }

    /** By how much a triangle counts at a corner, for its normal of length 1: |u × v| / (|u|² |v|²) with u and v the sides that leave it. */
    private double weight(int corner) {
        int t = corner / 3 * 3;
        Vec3 product = product(corner);
        double sine = Math.sqrt(product.dot(product));
        double u = square(corners[corner], corners[t + (corner + 1 - t) % 3]);
        double v = square(corners[corner], corners[t + (corner + 2 - t) % 3]);
        return u > 0 && v > 0 ? sine / (u * v) : 0;
    }

    private double square(int from, int to) {
        double x = at[3 * to] - at[3 * from];
        double y = at[3 * to + 1] - at[3 * from + 1];
        double z = at[3 * to + 2] - at[3 * from + 2];
        return x * x + y * y + z * z;
    }

    private Triangles result() {
        float[] perCorner = new float[3 * corners.length];
        double[] weights = new double[16];
        for (int p = 0; p + 1 < start.length; p++) {
            int count = start[p + 1] - start[p];
            weights = weights.length < count ? new double[2 * count] : weights;
            for (int i = 0; i < count; i++) {
                weights[i] = weight(around[start[p] + i]);
            }
            for (int i = 0; i < count; i++) {
                putNormal(start[p], count, i, weights, perCorner);
            }
        }
        return split(perCorner);
    }

    private void putNormal(int from, int count, int which, double[] weights, float[] out) {
        int own = around[from + which] / 3 * 3;
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = 0; i < count; i++) {
            int other = around[from + i] / 3 * 3;
            double alike = flat[own] * flat[other] + flat[own + 1] * flat[other + 1] + flat[own + 2] * flat[other + 2];
            if (alike >= cosine || count > FAN) {
                x += weights[i] * flat[other];
                y += weights[i] * flat[other + 1];
                z += weights[i] * flat[other + 2];
            }
        }
        double length = Math.sqrt(x * x + y * y + z * z);
        int to = 3 * around[from + which];
        boolean isKnown = length > 0 && length <= Double.MAX_VALUE;
        out[to] = isKnown ? (float) (x / length) : flat[own];
        out[to + 1] = isKnown ? (float) (y / length) : flat[own + 1];
        out[to + 2] = isKnown ? (float) (z / length) : flat[own + 2];
    }

    /** One vertex for all corners that had one before and still have one normal. */
    private Triangles split(float[] perCorner) {
        int vertices = mesh.vertexCount();
        int[] newest = new int[vertices];
        Arrays.fill(newest, -1);
        int[] of = new int[corners.length];
        int[] older = new int[corners.length];
        int[] sample = new int[corners.length];
        int count = 0;
        for (int i = 0; i < corners.length; i++) {
            int known = newest[corners[i]];
            while (known >= 0 && !same(perCorner, sample[known], i)) {
                known = older[known];
            }
            if (known < 0) {
                known = count++;
                sample[known] = i;
                older[known] = newest[corners[i]];
                newest[corners[i]] = known;
            }
            of[i] = known;
        }
        double[] places = new double[3 * count];
        float[] normals = new float[3 * count];
        float[] map = new float[mesh.hasMap() ? 2 * count : 0];
        float[] colors = new float[mesh.hasColors() ? 3 * count : 0];
        for (int v = 0; v < count; v++) {
            int old = corners[sample[v]];
            System.arraycopy(at, 3 * old, places, 3 * v, 3);
            System.arraycopy(perCorner, 3 * sample[v], normals, 3 * v, 3);
            if (mesh.hasMap()) {
                System.arraycopy(mesh.map(), 2 * old, map, 2 * v, 2);
            }
            if (mesh.hasColors()) {
                System.arraycopy(mesh.colors(), 3 * old, colors, 3 * v, 3);
            }
        }
        return new Triangles(places, of, normals, map, colors, mesh.parts(), mesh.partNumbers());
    }

    private static boolean same(float[] normals, int a, int b) {
        return normals[3 * a] == normals[3 * b] && normals[3 * a + 1] == normals[3 * b + 1] && normals[3 * a + 2] == normals[3 * b + 2];
    }
}
