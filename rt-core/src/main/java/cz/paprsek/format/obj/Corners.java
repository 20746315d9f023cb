package cz.paprsek.format.obj;

import cz.paprsek.format.model.Doubles;
import cz.paprsek.format.model.Floats;
import cz.paprsek.format.model.Ints;
import cz.paprsek.format.model.Pairs;
import cz.paprsek.shape.mesh.Triangles;
import java.util.Arrays;

/**
 * The corners of faces, each of which names a place, a point of a picture and a normal, as vertices that have all three; corners that name the same are one vertex. A corner
 * without a normal that belongs to a smoothing group gets the mean one of the triangles of its group around its place, weighted by their angles there.
 *
 * @source Thürmer and Wüthrich, Computing Vertex Normals from Polygonal Facets, Journal of Graphics Tools 3(1), 1998
 */
final class Corners {
    static final int NONE = -1;
    /** Of so many vertices in one place, others are not looked for any more: some come twice then. */
    private static final int MOST_TRIED = 64;
    private static final int FACTS = 4;
    private static final int BEFORE = 0;
    private static final int PLACE = 1;
    private static final int MAP = 2;
    private static final int NORMAL = 3;

    private final Triangles.Builder builder = Triangles.builder();
    private final Doubles places;
    private final Doubles normals;
    private final Doubles map;
    /** Of the first vertices; others are white. */
    private final Floats colors;
    /** For each place the vertex that was made last there. */
    private int[] last = new int[64];
    /** For each vertex, side by side: the one that was made before in its place, that, its point of a picture, and its normal, or −2 less its group. */
    private int[] facts = new int[FACTS * 64];
    private boolean hasGroups;

    Corners(Doubles places, Doubles normals, Doubles map, Floats colors) {
        this.places = places;
        this.normals = normals;
        this.map = map;
        this.colors = colors;
        Arrays.fill(last, NONE);
    }

    boolean isEmpty() {
        return builder.triangleCount() == 0;
    }

    int placeOf(int vertex) {
        return facts[FACTS * vertex + PLACE];
    }

    void part(String name) {
        builder.part(name);
    }

    /** @param group the smoothing group, or 0 */
    int vertex(int place, int uv, int normal, int group) {
        int wanted = normal == NONE && group != 0 ? -2 - group : normal;
        if (place >= last.length) {
            int old = last.length;
            last = Arrays.copyOf(last, Math.max(2 * old, places.size() / 3));
            Arrays.fill(last, old, last.length, NONE);
        }
        int known = last[place];
        for (int tried = 0; known != NONE && tried < MOST_TRIED; tried++) {
            int at = FACTS * known;
            if (facts[at + MAP] == uv && facts[at + NORMAL] == wanted) {
                return known;
            }
            known = facts[at + BEFORE];
        }
        int fresh = builder.vertex(places.get(3 * place), places.get(3 * place + 1), places.get(3 * place + 2));
        int at = FACTS * fresh;
        if (at + FACTS > facts.length) {
            facts = Arrays.copyOf(facts, Ints.larger(at));
        }
        facts[at + BEFORE] = last[place];
        facts[at + PLACE] = place;
        facts[at + MAP] = uv;
        facts[at + NORMAL] = wanted;
        last[place] = fresh;
        hasGroups |= wanted < NONE;
        if (normal != NONE) {
            builder.normal(fresh, normals.get(3 * normal), normals.get(3 * normal + 1), normals.get(3 * normal + 2));
        }
        if (uv != NONE) {
            builder.map(fresh, map.get(2 * uv), map.get(2 * uv + 1));
        }
        if (3 * place < colors.size()) {
            builder.color(fresh, colors.get(3 * place), colors.get(3 * place + 1), colors.get(3 * place + 2));
        }
        return fresh;
    }

    void triangle(int a, int b, int c) {
        int placeA = placeOf(a);
        int placeB = placeOf(b);
        int placeC = placeOf(c);
        if (placeA != placeB && placeB != placeC && placeA != placeC) {
            builder.triangle(a, b, c);
        }
    }

    Triangles build() {
        Triangles triangles = builder.build();
        return hasGroups ? smooth(triangles) : triangles;
    }

    private Triangles smooth(Triangles mesh) {
        Pairs pairs = new Pairs();
        Doubles sums = new Doubles();
        int[] numbers = new int[mesh.vertexCount()];
        for (int v = 0; v < numbers.length; v++) {
            numbers[v] = facts[FACTS * v + NORMAL] < NONE ? pairs.number(placeOf(v), facts[FACTS * v + NORMAL]) : NONE;
            while (sums.size() < 3 * pairs.size()) {
                sums.add(0);
            }
        }
        for (int t = 0; t < mesh.count(); t++) {
            for (int k = 0; k < 3; k++) {
                int number = numbers[mesh.corner(t, k)];
                if (number != NONE) {
                    add(mesh, t, k, sums, 3 * number);
                }
            }
        }
        return mesh.withNormals(withSums(mesh, numbers, sums));
    }

    private static float[] withSums(Triangles mesh, int[] numbers, Doubles sums) {
        float[] all = new float[3 * numbers.length];
        for (int v = 0; v < numbers.length; v++) {
            if (numbers[v] == NONE) {
                all[3 * v] = (float) mesh.normal(v).x();
                all[3 * v + 1] = (float) mesh.normal(v).y();
                all[3 * v + 2] = (float) mesh.normal(v).z();
            } else {
                for (int axis = 0; axis < 3; axis++) {
                    all[3 * v + axis] = (float) sums.get(3 * numbers[v] + axis);
                }
            }
        }
        return all;
    }

    /** Adds the normal of a triangle, of length 1, times its angle at a corner: so it makes no difference how faces were cut. */
    private static void add(Triangles mesh, int t, int k, Doubles sums, int to) {
        int a = mesh.corner(t, k);
        int b = mesh.corner(t, (k + 1) % 3);
        int c = mesh.corner(t, (k + 2) % 3);
        double ux = mesh.x(b) - mesh.x(a);
        double uy = mesh.y(b) - mesh.y(a);
        double uz = mesh.z(b) - mesh.z(a);
        double vx = mesh.x(c) - mesh.x(a);
        double vy = mesh.y(c) - mesh.y(a);
        double vz = mesh.z(c) - mesh.z(a);
        double x = uy * vz - uz * vy;
        double y = uz * vx - ux * vz;
        double z = ux * vy - uy * vx;
        double length = Math.sqrt(x * x + y * y + z * z);
        if (length > 0 && length < Double.POSITIVE_INFINITY) {
            double weight = StrictMath.atan2(length, ux * vx + uy * vy + uz * vz) / length;
            sums.set(to, sums.get(to) + weight * x);
            sums.set(to + 1, sums.get(to + 1) + weight * y);
            sums.set(to + 2, sums.get(to + 2) + weight * z);
        }
    }
}
