package cz.paprsek.shape.mesh;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import java.util.Arrays;
import java.util.BitSet;

/**
 * Joins what should meet at open edges and misses by rounding: places on open edges that are next to each other become one, that with the least x, y
 * and z of them. What lies elsewhere stays; so do places in a chain that is longer than twice the distance, or between which there is a side of a triangle: that is detail. The
 * order of vertices makes no difference.
 */
final class Seams {
    private static final int NONE = -1;
    /** With more places than this in one cell it is detail, and left as it is. */
    private static final int MOST_IN_CELL = 64;

    private final double[] places;
    private final double distance;
    /** The places on open edges, by their first vertices. */
    private final int[] rim;
    /** For each of these another one of its group, in the end the first one that it was joined with. */
    private final int[] joined;
    /** Cells of twice the distance: for each bucket one of the places in it, for each place the next. */
    private final int[] buckets;
    private final int[] next;

    private Seams(double[] places, BitSet onRim, double distance) {
        this.places = places;
        this.distance = distance;
        rim = onRim.stream().toArray();
        joined = new int[rim.length];
        next = new int[rim.length];
        buckets = new int[Integer.highestOneBit(Math.max(8, Math.min(rim.length, 1 << 29))) << 1];
        Arrays.fill(buckets, NONE);
        for (int i = 0; i < rim.length; i++) {
            joined[i] = i;
        }
    }

    /**
     * A mesh, closed as far as it can be.
     *
     * @param share of the diagonal of its box, how far places may be apart to be one
     * @return with the mesh itself if no edge less is open then
     */
    static Sewn sewn(Triangles mesh, Shells known, double share) {
        double distance = share * diagonal(mesh.bounds());
        if (known.openEdges() == 0 || !(distance > 0 && distance < Double.POSITIVE_INFINITY)) {
            return new Sewn(mesh, 0, 0);
        }
        Seams seams = new Seams(mesh.places(), known.rim(), distance);
        for (int i = 0; i < seams.rim.length; i++) {
            if (!seams.joinWithNeighbours(i)) {
                return new Sewn(mesh, 0, 0);
            }
        }
        int[] first = Weld.firsts(mesh.places());
        int[] group = seams.groups(mesh.vertexCount());
        int kept = seams.keep(mesh.corners(), first, group);
        int[] least = seams.least(group);
        double[] places = mesh.places().clone();
        int moved = 0;
        for (int v = 0; v < first.length; v++) {
            int its = group[first[v]];
            if (its != NONE && least[its] != first[v]) {
                System.arraycopy(mesh.places(), 3 * least[its], places, 3 * v, 3);
                moved += first[v] == v ? 1 : 0;
            }
        }
        if (moved == 0) {
            return new Sewn(mesh, 0, kept);
        }
        Triangles closer = new Triangles(places, mesh.corners(), mesh.normals(), mesh.map(), mesh.colors(), mesh.parts(), mesh.partNumbers());
        return closer.openEdges() < known.openEdges() ? new Sewn(closer, moved, kept) : new Sewn(mesh, 0, kept);
    }

    private static double diagonal(Bounds b) {
        return new Vec3(b.maxX() - b.minX(), b.maxY() - b.minY(), b.maxZ() - b.minZ()).length();
    }

    /** Joins a place with those before it that are near: they lie in its cell, or in one of the cells next to the corner of it that it is nearest to. False if there are too many. */
    private boolean joinWithNeighbours(int i) {
        long[] cell = new long[3];
        long[] beside = new long[3];
        for (int axis = 0; axis < 3; axis++) {
            double at = places[3 * rim[i] + axis] / (2 * distance);
            double floor = Math.floor(at);
            cell[axis] = (long) floor;
            beside[axis] = at - floor < 0.5 ? -1 : 1;
        }
        for (int k = 0; k < 8; k++) {
            int bucket = bucket(cell[0] + (k & 1) * beside[0], cell[1] + (k >> 1 & 1) * beside[1], cell[2] + (k >> 2) * beside[2]);
            int tried = 0;
            for (int other = buckets[bucket]; other != NONE; other = next[other]) {
                if (++tried > MOST_IN_CELL) {
                    return false;
                }
                if (areNear(rim[i], rim[other])) {
                    int a = find(i);
                    int b = find(other);
                    joined[Math.max(a, b)] = Math.min(a, b);
                }
            }
        }
        int own = bucket(cell[0], cell[1], cell[2]);
        next[i] = buckets[own];
        buckets[own] = i;
        return true;
    }

    private int bucket(long x, long y, long z) {
        long bits = x * 0x9E3779B97F4A7C15L;
        bits = (bits ^ bits >>> 32 ^ y) * 0xBF58476D1CE4E5B9L;
        bits = (bits ^ bits >>> 32 ^ z) * 0x94D049BB133111EBL;
        return (int) (bits >>> 32 ^ bits >>> 17) & buckets.length - 1;
    }

    private boolean areNear(int a, int b) {
        double x = places[3 * a] - places[3 * b];
        double y = places[3 * a + 1] - places[3 * b + 1];
        double z = places[3 * a + 2] - places[3 * b + 2];
        return x * x + y * y + z * z <= distance * distance;
    }

    private int find(int of) {
        int at = of;
        while (joined[at] != at) {
            joined[at] = joined[joined[at]];
            at = joined[at];
        }
        return at;
    }

    /** For each vertex that is the first one in its place the number of its group; none if it is not on the rim, or its group is too large. */
    private int[] groups(int vertices) {
        double[] box = new double[6 * rim.length];
        Arrays.fill(box, Double.POSITIVE_INFINITY);
        for (int i = 0; i < rim.length; i++) {
            int at = 6 * find(i);
            for (int axis = 0; axis < 3; axis++) {
                double value = places[3 * rim[i] + axis];
                box[at + axis] = Math.min(box[at + axis], value);
                box[at + 3 + axis] = Math.min(box[at + 3 + axis], -value);
            }
        }
        int[] group = new int[vertices];
        Arrays.fill(group, NONE);
        for (int i = 0; i < rim.length; i++) {
            int at = 6 * find(i);
            double size = -Math.min(box[at] + box[at + 3], Math.min(box[at + 1] + box[at + 4], box[at + 2] + box[at + 5]));
            group[rim[i]] = size <= 2 * distance ? find(i) : NONE;
        }
        return group;
    }

    /** Leaves groups as they are between whose places there is a side of a triangle, and returns how many such sides there are. */
    private int keep(int[] corners, int[] first, int[] group) {
        BitSet kept = new BitSet();
        int count = 0;
        for (int side = 0; side < corners.length; side++) {
            int from = first[corners[side]];
            int to = first[corners[side % 3 == 2 ? side - 2 : side + 1]];
            if (from != to && group[from] != NONE && group[from] == group[to]) {
                kept.set(group[from]);
                count++;
            }
        }
        for (int place : rim) {
            group[place] = group[place] != NONE && kept.get(group[place]) ? NONE : group[place];
        }
        return count;
    }

    /** For each group the first vertex of its place with the least x, of these y, of these z. */
    private int[] least(int[] group) {
        int[] least = new int[rim.length];
        Arrays.fill(least, NONE);
        for (int place : rim) {
            int its = group[place];
            if (its != NONE && (least[its] == NONE || isLess(place, least[its]))) {
                least[its] = place;
            }
        }
        return least;
    }

    private boolean isLess(int a, int b) {
        for (int axis = 0; axis < 3; axis++) {
            if (places[3 * a + axis] != places[3 * b + axis]) {
                return places[3 * a + axis] < places[3 * b + axis];
            }
        }
        return false;
    }
}
