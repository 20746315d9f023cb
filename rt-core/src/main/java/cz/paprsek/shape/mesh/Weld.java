package cz.paprsek.shape.mesh;

import java.util.Arrays;

/** Tells which vertices lie in one place: those with the same coordinates. */
final class Weld {
    private Weld() {}

    /** For each vertex the number of the first one in its place. */
    static int[] firsts(double[] places) {
        int count = places.length / 3;
        int[] first = new int[count];
        // An open table, at most half full, of vertices that are the first in their places.
        int size = Integer.highestOneBit(Math.max(8, Math.min(count, 1 << 29))) << 2;
        int[] table = new int[Math.min(size, 1 << 30)];
        Arrays.fill(table, -1);
        for (int v = 0; v < count; v++) {
            double x = places[3 * v];
            double y = places[3 * v + 1];
            double z = places[3 * v + 2];
            int at = hash(x, y, z) & (table.length - 1);
            int other = table[at];
            while (other >= 0 && !(places[3 * other] == x && places[3 * other + 1] == y && places[3 * other + 2] == z)) {
                at = (at + 1) & (table.length - 1);
                other = table[at];
            }
            if (other < 0) {
                table[at] = v;
                other = v;
            }
            first[v] = other;
        }
        return first;
    }

    /** + 0.0 makes one zero of both. */
    private static int hash(double x, double y, double z) {
        long bits = Double.doubleToRawLongBits(x + 0.0) * 0x9E3779B97F4A7C15L;
        bits = (bits ^ bits >>> 32 ^ Double.doubleToRawLongBits(y + 0.0)) * 0xBF58476D1CE4E5B9L;
        bits = (bits ^ bits >>> 32 ^ Double.doubleToRawLongBits(z + 0.0)) * 0x94D049BB133111EBL;
        return (int) (bits >>> 32 ^ bits >>> 17);
    }
}
