package cz.paprsek.tree;

import java.util.function.BooleanSupplier;
import java.util.function.IntToDoubleFunction;

/** A binary tree as {@link TreeBuilder} makes it, of which a {@link Kernel} makes what it searches. Read only. */
final class BinaryNodes {
    /** As {@link BinaryTree} has them. */
    final double[] boxes;
    final int[] child;
    /** The root's name: inner node 0 unless it is a leaf. */
    final int root;
    /** How many nodes lie from the root to the farthest leaf, both counted; 0 if there is nothing. */
    final int depth;

    private final IntToDoubleFunction cost;
    private final BooleanSupplier stop;

    /**
     * @param cost of the item at a place in the order of the leaves, in units of what a sphere takes
     * @param stop whether whoever makes something of it is to give up
     */
    BinaryNodes(double[] boxes, int[] child, int root, int depth, IntToDoubleFunction cost, BooleanSupplier stop) {
        this.boxes = boxes;
        this.child = child;
        this.root = root;
        this.depth = depth;
        this.cost = cost;
        this.stop = stop;
    }

    int count() {
        return child.length / 2;
    }

    /** To be called with the number of each node that something is made of. */
    void stopIfAsked(int node) {
        TreeBuilder.stopIfAsked(node, stop);
    }

    /** What it costs to meet all items from one place to before another. */
    double cost(int first, int end) {
        double sum = 0;
        for (int i = first; i < end; i++) {
            sum += cost.applyAsDouble(i);
        }
        return sum;
    }

    /** Half the surface of the box that begins at a place. */
    double halfArea(int at) {
        double x = boxes[at + 3] - boxes[at];
        double y = boxes[at + 4] - boxes[at + 1];
        double z = boxes[at + 5] - boxes[at + 2];
        return x * y + y * z + z * x;
    }

    /** Half the surface of the box around both children of a node. */
    double halfAreaOf(int node) {
        int a = 12 * node;
        int b = a + 6;
        double x = Math.max(boxes[a + 3], boxes[b + 3]) - Math.min(boxes[a], boxes[b]);
        double y = Math.max(boxes[a + 4], boxes[b + 4]) - Math.min(boxes[a + 1], boxes[b + 1]);
        double z = Math.max(boxes[a + 5], boxes[b + 5]) - Math.min(boxes[a + 2], boxes[b + 2]);
        return x * y + y * z + z * x;
    }
}
