package cz.paprsek.render.light;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Bodies that shine in a tree, to choose one of them as often as it may bring light: at each node that half which is stronger, by the square of its distance, or of its size where that is
 * larger. Immutable.
 *
 * @source Conty Estevez and Kulla, Importance Sampling of Many Lights with Adaptive Tree Splitting, Proceedings of the ACM on Computer Graphics and Interactive Techniques 1(2), 2018
 */
final class LampTree {
    private static final int ROOT = 0;
    private static final int NONE = -1;
    private static final double MOST_LEFT = Math.nextDown(1.0);

    /** By nodes; of leaves the first child is the lamp, as −1 − its number. */
    private final int[] first;
    private final int[] second;
    private final int[] parent;
    private final double[] x;
    private final double[] y;
    private final double[] z;
    /** The square of half the diagonal of its box. */
    private final double[] size;
    private final double[] power;
    /** By lamps. */
    private final int[] leaf;
    private int nodes;

    /** @param powers what each gives off in all, above 0 */
    LampTree(List<Bounds> boxes, double[] powers) {
        int count = powers.length;
        int most = 2 * count - 1;
        first = new int[most];
        second = new int[most];
        parent = new int[most];
        x = new double[most];
        y = new double[most];
        z = new double[most];
        size = new double[most];
        power = new double[most];
        leaf = new int[count];
        Integer[] order = new Integer[count];
        Arrays.setAll(order, i -> i);
        build(order, 0, count, NONE, boxes, powers);
    }

    private int build(Integer[] order, int from, int to, int above, List<Bounds> boxes, double[] powers) {
        int node = nodes++;
        parent[node] = above;
        Bounds box = Bounds.EMPTY;
        double sum = 0;
        for (int i = from; i < to; i++) {
            box = box.union(boxes.get(order[i]));
            sum += powers[order[i]];
        }
        Vec3 half = new Vec3(box.maxX() - box.minX(), box.maxY() - box.minY(), box.maxZ() - box.minZ()).times(0.5);
        x[node] = (box.minX() + box.maxX()) / 2;
        y[node] = (box.minY() + box.maxY()) / 2;
        z[node] = (box.minZ() + box.maxZ()) / 2;
        size[node] = half.dot(half);
        power[node] = sum;
        if (to - from == 1) {
            first[node] = NONE - order[from];
            leaf[order[from]] = node;
            return node;
        }
        Arrays.sort(order, from, to, Comparator.<Integer>comparingDouble(i -> along(boxes.get(i), half)).thenComparing(Comparator.naturalOrder()));
        int between = (from + to) >>> 1;
        first[node] = build(order, from, between, node, boxes, powers);
        second[node] = build(order, between, to, node, boxes, powers);
        return node;
    }

    /** Twice how far a box's middle is along the longest side. */
    private static double along(Bounds box, Vec3 half) {
        return half.x() >= half.y() && half.x() >= half.z() ? box.minX() + box.maxX()
                : half.y() >= half.z() ? box.minY() + box.maxY() : box.minZ() + box.maxZ();
    }

    private double strength(int node, double px, double py, double pz) {
        double dx = x[node] - px;
        double dy = y[node] - py;
        double dz = z[node] - pz;
        return power[node] / Math.max(dx * dx + dy * dy + dz * dz, size[node]);
    }

    /** How often of two halves the first is chosen from a point. */
    private double share(int node, double px, double py, double pz) {
        double one = strength(first[node], px, py, pz);
        double other = strength(second[node], px, py, pz);
        double share = one / (one + other);
        // In the middle of lamps without a size both are infinite, and far off all may be nothing.
        return share >= 0 && share <= 1 ? share : 0.5;
    }

    /** Chooses a lamp as seen from a point. */
    void choose(double px, double py, double pz, double u, Choice out) {
        int node = ROOT;
        double chance = 1;
        double left = u;
        while (first[node] >= 0) {
            double share = share(node, px, py, pz);
            if (left < share) {
                left /= share;
                chance *= share;
                node = first[node];
            } else {
                left = (left - share) / (1 - share);
                chance *= 1 - share;
                node = second[node];
            }
        }
        out.lamp = NONE - first[node];
        out.chance = chance;
        out.left = Math.min(left, MOST_LEFT);
    }

    /** How often a lamp is chosen as seen from a point. */
    double chance(int lamp, double px, double py, double pz) {
        double chance = 1;
        int node = leaf[lamp];
        while (parent[node] >= 0) {
            int above = parent[node];
            double share = share(above, px, py, pz);
            chance *= first[above] == node ? share : 1 - share;
            node = above;
        }
        return chance;
    }

    /** Scratch of one worker: a lamp that was chosen. */
    static final class Choice {
        int lamp;
        double chance;
        /** What is left of the random number: again one from 0 to 1. */
        double left;
    }
}
