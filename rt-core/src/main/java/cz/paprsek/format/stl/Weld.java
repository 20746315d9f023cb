package cz.paprsek.format.stl;

import cz.paprsek.format.model.Ints;
import cz.paprsek.material.Rgb;
import cz.paprsek.shape.mesh.Triangles;
import java.util.Arrays;

/** Puts triangles together whose corners are said one by one: corners with the very same numbers and one colour are one vertex. Triangles with two corners in one place are left out. */
final class Weld {
    private static final int WHITE = 0xFFFFFF;

    private final Triangles.Builder builder = Triangles.builder();
    private double[] places = new double[3 << 10];
    /** sRGB of each vertex, a byte for each channel. */
    private final Ints colors = new Ints();
    private int color = WHITE;
    /** For each bucket a vertex and 1, or 0: open addressing. */
    private int[] buckets = new int[1 << 11];
    private final int[] corners = new int[3];

    /** Of the corners that come from now on, sRGB, a byte for each channel. */
    void color(int value) {
        color = value;
    }

    void part(String name) {
        builder.part(name);
    }

    void corner(int k, double x, double y, double z) {
        // Adding 0 makes the one zero of both.
        corners[k] = vertex(x + 0.0, y + 0.0, z + 0.0);
    }

    void triangle() {
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[0] != corners[2]) {
            builder.triangle(corners[0], corners[1], corners[2]);
        }
    }

    boolean isEmpty() {
        return builder.triangleCount() == 0;
    }

    Triangles build() {
        return builder.build();
    }

    private int vertex(double x, double y, double z) {
        int mask = buckets.length - 1;
        int at = hash(x, y, z) + color & mask;
        for (; buckets[at] != 0; at = (at + 1) & mask) {
            int known = buckets[at] - 1;
            if (places[3 * known] == x && places[3 * known + 1] == y && places[3 * known + 2] == z && colors.get(known) == color) {
                return known;
            }
        }
        int fresh = builder.vertex(x, y, z);
        colors.add(color);
        if (color != WHITE) {
            builder.color(fresh, Rgb.linear(color >> 16), Rgb.linear(color >> 8 & 255), Rgb.linear(color & 255));
        }
        buckets[at] = fresh + 1;
        if (3 * fresh + 3 > places.length) {
            places = Arrays.copyOf(places, Math.max(3 * fresh + 3, (int) Math.min(Integer.MAX_VALUE - 8L, 2L * places.length)));
        }
        places[3 * fresh] = x;
        places[3 * fresh + 1] = y;
        places[3 * fresh + 2] = z;
        if (2L * fresh > buckets.length && buckets.length < 1 << 30) {
            enlarge(fresh + 1);
        }
        return fresh;
    }

    private void enlarge(int count) {
        buckets = new int[2 * buckets.length];
        int mask = buckets.length - 1;
        for (int i = 0; i < count; i++) {
            int at = hash(places[3 * i], places[3 * i + 1], places[3 * i + 2]) + colors.get(i) & mask;
            while (buckets[at] != 0) {
                at = (at + 1) & mask;
            }
            buckets[at] = i + 1;
        }
    }

    private static int hash(double x, double y, double z) {
        long h = Double.doubleToRawLongBits(x) * 0x9E3779B97F4A7C15L;
        h = (h ^ (h >>> 29) ^ Double.doubleToRawLongBits(y)) * 0xBF58476D1CE4E5B9L;
        h = (h ^ (h >>> 32) ^ Double.doubleToRawLongBits(z)) * 0x94D049BB133111EBL;
        return (int) (h ^ (h >>> 32));
    }
}
