package cz.paprsek.shape.mesh;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.tree.Tree;
import cz.paprsek.tree.TreeBuilder;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Triangles in a tree, in their own space, ready for rays: wherever a mesh stands, and however often, it is made once. Immutable.
 */
final class Facets {
    /** By so much of the mesh's largest coordinate boxes are grown, far more than rounding moves a crossing. */
    private static final double MARGIN = 1e-12;

    /** What it takes to meet a triangle, in units of what a sphere takes, as measured: with 1, vectors meet a tenth fewer shadow rays in a second. */
    private static final float COST = 2;

    /** How many numbers a triangle takes among {@link #corners}, and among those of {@link #own}. */
    static final int EACH = 4;
    static final int EACH_OWN = 10;

    final double[] places;
    /** In the order of the tree's leaves: the corners of each triangle, as where their coordinates begin, and its number. Empty if there are {@link #own}. */
    final int[] corners;
    /**
     * In the order of the tree's leaves: x y z of the three corners of each triangle, and its number as bits, where all coordinates are floats, as in most files; else empty. A ray that
     * goes where none has been before waits for memory once a leaf, rather than for the corners, their places and the number in turn.
     */
    final float[] own;
    final Tree tree;
    private final int count;
    /** The box around all, grown likewise. */
    final Bounds box;

    /** @throws java.util.concurrent.CancellationException if it was to stop */
    Facets(Triangles mesh, BooleanSupplier stop) {
        places = mesh.places();
        int[] vertices = mesh.corners();
        count = mesh.count();
        double margin = MARGIN * mesh.bounds().magnitude();
        box = mesh.bounds().grown(margin);
        int[] numbers = new int[count];
        Arrays.setAll(numbers, t -> t);
        float[] cost = new float[count];
        Arrays.fill(cost, COST);
        // Building puts the numbers into the order of the leaves.
        tree = new TreeBuilder((t, to, at) -> putBox(vertices, t, margin, to, at), numbers, cost, stop).buildWhole();
        boolean areFloats = Arrays.stream(places).allMatch(x -> x == (float) x);
        own = new float[areFloats ? EACH_OWN * count : 0];
        corners = new int[areFloats ? 0 : EACH * count];
        for (int i = 0; i < count; i++) {
            if (areFloats) {
                own[EACH_OWN * i + 9] = Float.intBitsToFloat(numbers[i]);
            } else {
                corners[EACH * i + 3] = numbers[i];
            }
            for (int k = 0; k < 3; k++) {
                int at = 3 * vertices[3 * numbers[i] + k];
                if (areFloats) {
                    for (int axis = 0; axis < 3; axis++) {
                        own[EACH_OWN * i + 3 * k + axis] = (float) places[at + axis];
                    }
                } else {
                    corners[EACH * i + k] = at;
                }
            }
        }
    }

    /** The number of the triangle at a place in the order of the leaves. */
    int number(int place) {
        return own.length > 0 ? Float.floatToRawIntBits(own[EACH_OWN * place + 9]) : corners[EACH * place + 3];
    }

    /** Whether a place in the order of the leaves, any number, is that of a triangle. */
    boolean isAt(int place, int triangle) {
        return place >= 0 && place < count && number(place) == triangle;
    }

    /** The {@linkplain Measures#product normal} of the triangle at a place, as its corners give it. */
    Vec3 product(int place) {
        return own.length > 0 ? Measures.product(own, EACH_OWN * place) : Measures.product(places, corners[EACH * place], corners[EACH * place + 1], corners[EACH * place + 2]);
    }

    private void putBox(int[] vertices, int triangle, double margin, double[] to, int at) {
        int a = 3 * vertices[3 * triangle];
        int b = 3 * vertices[3 * triangle + 1];
        int c = 3 * vertices[3 * triangle + 2];
        for (int k = 0; k < 3; k++) {
            double p = places[a + k];
            double q = places[b + k];
            double r = places[c + k];
            to[at + k] = (p < q ? p < r ? p : r : q < r ? q : r) - margin;
            to[at + 3 + k] = (p > q ? p > r ? p : r : q > r ? q : r) + margin;
        }
    }
}
