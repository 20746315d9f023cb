package cz.paprsek.shape.mesh;

import cz.paprsek.math.Require;
import java.util.Arrays;

/** How long arrays are made that grow while vertices and triangles are added, and how they are handed over. */
final class Growing {
    /** As many numbers as an array can hold, in threes. */
    private static final int MOST = (Integer.MAX_VALUE - 15) / 3 * 3;
    private static final String TOO_MANY = "a mesh has at most " + MOST / 3 + " vertices and as many triangles";

    private Growing() {}

    /** The length for so many vertices or triangles, of three numbers each. */
    static int threes(int count) {
        Require.that(count <= MOST / 3, TOO_MANY + ", but here are " + count);
        return 3 * Math.max(0, count);
    }

    /** The next length. */
    static int from(int length) {
        Require.that(length < MOST, TOO_MANY);
        return (int) Math.min(2L * length, MOST);
    }

    /** As long as it is filled, or to be filled with 0; what is empty stays so. */
    static double[] cut(double[] values, int length) {
        return values.length == 0 || values.length == length ? values : Arrays.copyOf(values, length);
    }

    static float[] cut(float[] values, int length) {
        return values.length == 0 || values.length == length ? values : Arrays.copyOf(values, length);
    }

    static int[] cut(int[] values, int length) {
        return values.length == 0 || values.length == length ? values : Arrays.copyOf(values, length);
    }
}
