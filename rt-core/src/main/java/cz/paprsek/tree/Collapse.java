package cz.paprsek.tree;

import java.util.Arrays;

/**
 * Chooses which nodes of a binary tree are left, as children of wide ones, and which of its leaves become one, so that a ray is expected to cost least: for every node what it
 * would cost to have all below it as at most so many children of one wide node, from the leaves up. Scratch of building.
 *
 * @source Ylitie, Karras, Laine, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, HPG 2017, section 3.1
 */
final class Collapse {
    /** What it takes to visit a node, and a leaf besides its items, in units of what it takes to meet a sphere there: 26 and 12 to 4 ns, as measured. */
    private static final float NODE = 6.5F;
    private static final float LEAF = 3;

    private final BinaryNodes nodes;
    private final int width;
    /** By what surfaces are multiplied: to that of the whole they are at most about 1. */
    private final double unit;
    /** Of node n at {@code width · n + k − 1} what it costs as at most k children of a wide node; in the last place what it costs as a node of its own. */
    private final float[] cost;
    /** What each node would be called as a leaf; 0 if it has too many items. */
    private final int[] leaf;
    /** What both children of a node cost as at most so many. */
    private final float[] left;
    private final float[] right;
    /** The children of the wide node that is being made: where their boxes begin. */
    private final int[] boxes;
    private int count;

    Collapse(BinaryNodes nodes, int width) {
        this.nodes = nodes;
        this.width = width;
        double whole = nodes.halfAreaOf(0);
        unit = whole > 0 ? 1 / whole : 1;
        cost = new float[Math.multiplyExact(nodes.count(), width)];
        leaf = new int[nodes.count()];
        left = new float[width];
        right = new float[width];
        boxes = new int[width];
        weigh(nodes.root);
    }

    private void weigh(int node) {
        nodes.stopIfAsked(node);
        for (int side = 0; side < 2; side++) {
            int name = nodes.child[2 * node + side];
            if (name >= 0) {
                weigh(name);
            }
        }
        look(2 * node, left);
        look(2 * node + 1, right);
        float area = (float) (nodes.halfAreaOf(node) * unit);
        leaf[node] = join(leafAt(2 * node), leafAt(2 * node + 1));
        int at = width * node;
        cost[at + width - 1] = least(width) + area * NODE;
        float best = Math.min(cost[at + width - 1], leaf[node] == 0 ? Float.POSITIVE_INFINITY : ofLeaf(area, leaf[node]));
        cost[at] = best;
        for (int k = 2; k < width; k++) {
            best = Math.min(best, least(k));
            cost[at + k - 1] = best;
        }
    }

    /** What both children cost together as at most so many. */
    private float least(int many) {
        // More of them never cost more; of a leaf not less, either.
        if (left[1] == left[many - 1]) {
            return left[1] + right[many - 1];
        }
        if (right[1] == right[many - 1]) {
            return left[many - 1] + right[1];
        }
        float best = Float.POSITIVE_INFINITY;
        for (int k = 1; k < many; k++) {
            best = Math.min(best, left[k] + right[many - k]);
        }
        return best;
    }

    /** Takes down what a child costs, as 1 to width − 1 of them. */
    private void look(int child, float[] to) {
        int name = nodes.child[child];
        if (name >= 0) {
            System.arraycopy(cost, width * name, to, 1, width - 1);
        } else {
            float one = ofLeaf((float) (nodes.halfArea(6 * child) * unit), name);
            for (int k = 1; k < width; k++) {
                to[k] = one;
            }
        }
    }

    private float ofLeaf(float area, int name) {
        return area * (LEAF + (float) nodes.cost(Tree.first(name), Tree.end(name)));
    }

    private int leafAt(int child) {
        int name = nodes.child[child];
        return name < 0 ? name : leaf[name];
    }

    /** The leaf of the items of two that are neighbours; 0 if there are too many, or one is none. */
    private int join(int one, int other) {
        if (one == 0 || other == 0) {
            return 0;
        }
        int first = Math.min(Tree.first(one), Tree.first(other));
        int end = Math.max(Tree.end(one), Tree.end(other));
        return end - first > Tree.LEAF ? 0 : Tree.leaf(first, end - first, nodes.cost(first, end));
    }

    /** Finds the children of the wide node that is made of an inner one, and returns where their boxes begin. */
    int[] children(int node) {
        count = 0;
        open(node, width);
        return Arrays.copyOf(boxes, count);
    }

    /** What the child whose box begins at a place is: a leaf's name, or the inner node of which a wide one is to be made. */
    int name(int box) {
        int name = nodes.child[box / 6];
        return name < 0 || leaf[name] == 0 || cost[width * name] == cost[width * name + width - 1] ? name : leaf[name];
    }

    private void open(int node, int many) {
        look(2 * node, left);
        look(2 * node + 1, right);
        int first = 1;
        float best = Float.POSITIVE_INFINITY;
        for (int k = 1; k < many; k++) {
            float sum = left[k] + right[many - k];
            if (sum < best) {
                best = sum;
                first = k;
            }
        }
        spread(12 * node, first);
        spread(12 * node + 6, many - first);
    }

    /** Makes what has a box at most so many children. */
    private void spread(int box, int most) {
        int name = nodes.child[box / 6];
        int many = name < 0 ? 1 : most;
        while (many > 1 && cost[width * name + many - 1] == cost[width * name + many - 2]) {
            many--;
        }
        if (many == 1) {
            boxes[count++] = box;
        } else {
            open(name, many);
        }
    }
}
