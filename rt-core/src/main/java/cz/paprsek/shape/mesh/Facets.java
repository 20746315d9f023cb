package cz.paprsek.shape.mesh;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.tree.Sieve;
import cz.paprsek.tree.Tree;
import cz.paprsek.tree.TreeBuilder;
import java.util.Arrays;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Triangles in a tree, in their own space, ready for rays: wherever a mesh stands, and however often, it is made once. Immutable.
 */
final class Facets {
    /** By so much of the mesh's largest coordinate boxes are grown, far more than rounding moves a crossing. */
    private static final double MARGIN = 1e-12;

    /** A triangle seen as thinner than this, in units of how far away and how long it is, may be so by rounding alone: ten thousand times what doubles tell. */
    private static final double SEEN_THIN = 1e-12;

    /** One that is thinner than this, in units of its length, may be seen so. */
    private static final double THIN = 1e-9;

    /** What it takes to meet a triangle, in units of what a sphere takes, as measured: with 1, vectors meet a tenth fewer shadow rays in a second. */
    private static final float COST = 2;

    /** How many numbers a triangle takes among {@link #corners}. */
    static final int EACH = 4;

    final double[] places;
    /** In the order of the tree's leaves: the corners of each triangle, as where their coordinates begin, and its number. Empty if there are {@link #own}. */
    final int[] corners;
    /**
     * In the order of the tree's leaves: x of the three corners of each triangle, then y, z, and its number as bits, where all coordinates are floats, as in most files; else empty. A ray that
     * goes where none has been before waits for memory once a leaf, rather than for the corners, their places and the number in turn.
     */
    final float[] own;
    /** What passes by some of those. */
    final Sieve sieve;
    final Tree tree;
    private final int count;
    /** Whether any triangle is so thin that rounding may tell where it is crossed. */
    final boolean areAnyThin;
    /** By how much boxes are grown. */
    final double margin;
    /** The box around all, grown likewise. */
    final Bounds box;

    /** @throws java.util.concurrent.CancellationException if it was to stop */
    Facets(Triangles mesh, BooleanSupplier stop) {
        places = mesh.places();
        int[] vertices = mesh.corners();
        count = mesh.count();
        margin = MARGIN * mesh.bounds().magnitude();
        box = mesh.bounds().grown(margin);
        int[] numbers = new int[count];
        Arrays.setAll(numbers, t -> t);
        float[] cost = new float[count];
        Arrays.fill(cost, COST);
        // Building puts the numbers into the order of the leaves.
        tree = new TreeBuilder((t, to, at) -> putBox(vertices, t, to, at), numbers, cost, stop).buildWhole();
        sieve = Sieve.suitedTo(count, COST);
        boolean areFloats = Arrays.stream(places).allMatch(x -> x == (float) x);
        own = new float[areFloats ? Sieve.EACH * count + Sieve.BEHIND : 0];
        corners = new int[areFloats ? 0 : EACH * count];
        for (int i = 0; i < count; i++) {
            if (areFloats) {
                own[Sieve.EACH * i + 9] = Float.intBitsToFloat(numbers[i]);
            } else {
                corners[EACH * i + 3] = numbers[i];
            }
            for (int k = 0; k < 3; k++) {
                int at = 3 * vertices[3 * numbers[i] + k];
                if (areFloats) {
                    for (int axis = 0; axis < 3; axis++) {
                        own[Sieve.EACH * i + 3 * axis + k] = (float) places[at + axis];
                    }
                } else {
                    corners[EACH * i + k] = at;
                }
            }
        }
        areAnyThin = IntStream.range(0, count).anyMatch(this::isThin);
    }

    /** The number of the triangle at a place in the order of the leaves. */
    int number(int place) {
        return own.length > 0 ? Float.floatToRawIntBits(own[Sieve.EACH * place + 9]) : corners[EACH * place + 3];
    }

    /**
     * Where a line, of which o and reciprocals are given, crosses the triangle at a place, or no number: as it was found, unless the triangle has no area as the line sees it.
     * Then rounding alone tells whether and where, and that must not hang on which boxes of the tree are asked: so it is where the line goes through the triangle's own box.
     */
    double within(int place, double where, double seenArea, double ox, double oy, double oz, double rx, double ry, double rz) {
        double extent = extent(place);
        return seenArea > SEEN_THIN * extent * (extent + Math.abs(ox) + Math.abs(oy) + Math.abs(oz)) ? where : inBox(place, where, ox, oy, oz, rx, ry, rz);
    }

    private boolean isThin(int place) {
        Vec3 product = product(place);
        double extent = extent(place);
        return !(Math.abs(product.x()) + Math.abs(product.y()) + Math.abs(product.z()) > THIN * extent * extent);
    }

    private double extent(int place) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            double a = place(place, 0, k);
            sum += Math.abs(place(place, 1, k) - a) + Math.abs(place(place, 2, k) - a);
        }
        return sum;
    }

    private double inBox(int place, double where, double ox, double oy, double oz, double rx, double ry, double rz) {
        double low = Double.NEGATIVE_INFINITY;
        double high = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            double a = place(place, 0, k);
            double b = place(place, 1, k);
            double c = place(place, 2, k);
            double o = k == 0 ? ox : k == 1 ? oy : oz;
            double r = k == 0 ? rx : k == 1 ? ry : rz;
            double first = (Math.min(a, Math.min(b, c)) - margin - o) * r;
            double last = (Math.max(a, Math.max(b, c)) + margin - o) * r;
            low = Math.max(low, Math.min(first, last));
            high = Math.min(high, Math.max(first, last));
        }
        double slack = SEEN_THIN * (Math.abs(low) + Math.abs(high));
        return !(low <= high) ? Double.NaN : where < low - slack ? low : where > high + slack ? high : where;
    }

    private double place(int place, int corner, int axis) {
        return own.length > 0 ? own[Sieve.EACH * place + 3 * axis + corner] : places[corners[EACH * place + corner] + axis];
    }

    /** Whether a place in the order of the leaves, any number, is that of a triangle. */
    boolean isAt(int place, int triangle) {
        return place >= 0 && place < count && number(place) == triangle;
    }

    /** The {@linkplain Measures#product normal} of the triangle at a place, as its corners give it. */
    Vec3 product(int place) {
        return own.length > 0 ? Measures.product(own, Sieve.EACH * place) : Measures.product(places, corners[EACH * place], corners[EACH * place + 1], corners[EACH * place + 2]);
    }

    private void putBox(int[] vertices, int triangle, double[] to, int at) {
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
