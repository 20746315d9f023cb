package cz.paprsek.format.model;

import java.util.Arrays;

/**
 * A flat face of any number of corners, cut into triangles: from its first corner if it is convex, else by clipping ears. A face that crosses itself is
 * cut somehow; so is one that would take too long, of which there is only so much for a whole file. Used again and again.
 *
 * @source Meisters, Polygons Have Ears, American Mathematical Monthly 82(6), 1975
 */
public final class Polygon {
    /** What to note if {@link #isHurried}. */
    public static final String HURRIED = "faces have so many corners, and bend so often, that these and later ones are cut into triangles somehow";

    /** How many corners may be looked at in search of ears, in all faces together. */
    private static final long MOST_LOOKS = 400_000_000L;

    private long looks = MOST_LOOKS;
    private boolean isHurried;
    private double[] places = new double[3 * 16];
    private int[] vertices = new int[16];
    private int count;
    /** The corners as seen along the normal, counter-clockwise. */
    private double[] flat = new double[2 * 16];
    private int[] before = new int[16];
    private int[] after = new int[16];

    /** Takes triangles by the numbers of their vertices. */
    @FunctionalInterface
    public interface Sink {
        void triangle(int a, int b, int c);
    }

    public void clear() {
        count = 0;
    }

    public int count() {
        return count;
    }

    public void add(int vertex, double x, double y, double z) {
        if (count == vertices.length) {
            int larger = Ints.larger(count);
            vertices = Arrays.copyOf(vertices, larger);
            places = Arrays.copyOf(places, Math.multiplyExact(3, larger));
            flat = new double[2 * larger];
            before = new int[larger];
            after = new int[larger];
        }
        vertices[count] = vertex;
        places[3 * count] = x;
        places[3 * count + 1] = y;
        places[3 * count++ + 2] = z;
    }

    /** Whether a face was cut somehow, as it would have taken too long. */
    public boolean isHurried() {
        return isHurried;
    }

    /** Two triangles less than there are corners, turned as the face is. */
    public void cut(Sink sink) {
        if (count == 3) {
            sink.triangle(vertices[0], vertices[1], vertices[2]);
        } else if (!flatten() || isConvex()) {
            for (int i = 2; i < count; i++) {
                sink.triangle(vertices[0], vertices[i - 1], vertices[i]);
            }
        } else {
            clip(sink);
        }
    }

    /** Looks along the axis that the normal is nearest to; false if there is no normal. */
    private boolean flatten() {
        double nx = 0;
        double ny = 0;
        double nz = 0;
        for (int i = 0, j = count - 1; i < count; j = i++) {
            double ax = places[3 * j] - places[0];
            double ay = places[3 * j + 1] - places[1];
            double az = places[3 * j + 2] - places[2];
            double bx = places[3 * i] - places[0];
            double by = places[3 * i + 1] - places[1];
            double bz = places[3 * i + 2] - places[2];
            nx += ay * bz - az * by;
            ny += az * bx - ax * bz;
            nz += ax * by - ay * bx;
        }
        double x = Math.abs(nx);
        double y = Math.abs(ny);
        double z = Math.abs(nz);
        int first = z >= x && z >= y ? 0 : x >= y ? 1 : 2;
        double sign = first == 0 ? nz : first == 1 ? nx : ny;
        for (int i = 0; i < count; i++) {
            double u = places[3 * i + first] - places[first];
            double v = places[3 * i + (first + 1) % 3] - places[(first + 1) % 3];
            flat[2 * i] = sign < 0 ? v : u;
            flat[2 * i + 1] = sign < 0 ? u : v;
        }
        return sign != 0 && Double.isFinite(sign);
    }

    private boolean isConvex() {
        for (int i = 0; i < count; i++) {
            if (turn(i, (i + 1) % count, (i + 2) % count) < 0) {
                return false;
            }
        }
        return true;
    }

    /** Twice the area of a triangle, above 0 if it is counter-clockwise. */
    private double turn(int a, int b, int c) {
        return (flat[2 * b] - flat[2 * a]) * (flat[2 * c + 1] - flat[2 * a + 1]) - (flat[2 * b + 1] - flat[2 * a + 1]) * (flat[2 * c] - flat[2 * a]);
    }

    private void clip(Sink sink) {
        for (int i = 0; i < count; i++) {
            before[i] = (i + count - 1) % count;
            after[i] = (i + 1) % count;
        }
        int at = 0;
        int tried = 0;
        for (int left = count; left > 3;) {
            if (isEar(at, left) || tried > left) {
                sink.triangle(vertices[before[at]], vertices[at], vertices[after[at]]);
                after[before[at]] = after[at];
                before[after[at]] = before[at];
                left--;
                // Two on: ears next to each other make thin triangles. Once nothing is an ear, nothing is expected to be.
                at = after[after[at]];
                tried = tried > left ? Integer.MAX_VALUE : 0;
            } else {
                at = after[at];
                tried++;
            }
        }
        sink.triangle(vertices[before[at]], vertices[at], vertices[after[at]]);
    }

    private boolean isEar(int at, int left) {
        int a = before[at];
        int c = after[at];
        double area = turn(a, at, c);
        if (looks <= 0) {
            isHurried = true;
            return true;
        }
        if (area <= 0) {
            // A corner in the middle of an edge can go as soon as its neighbours do not fold back.
            return area == 0 && isBetween(a, at, c);
        }
        looks -= left;
        for (int i = after[c]; i != a; i = after[i]) {
            if (turn(before[i], i, after[i]) <= 0 && isWithin(i, a, at, c)) {
                return false;
            }
        }
        return true;
    }

    private boolean isBetween(int a, int b, int c) {
        return (flat[2 * b] - flat[2 * a]) * (flat[2 * c] - flat[2 * b]) + (flat[2 * b + 1] - flat[2 * a + 1]) * (flat[2 * c + 1] - flat[2 * b + 1]) >= 0;
    }

    /** Whether a corner lies in a triangle or on its edge, but not in the place of one of its corners, which a bridge to a hole has twice. */
    private boolean isWithin(int i, int a, int b, int c) {
        return turn(a, b, i) >= 0 && turn(b, c, i) >= 0 && turn(c, a, i) >= 0 && !isSame(i, a) && !isSame(i, b) && !isSame(i, c);
    }

    private boolean isSame(int i, int j) {
        return flat[2 * i] == flat[2 * j] && flat[2 * i + 1] == flat[2 * j + 1];
    }
}
