package cz.paprsek.tree;

import java.util.Arrays;
import java.util.Optional;

/**
 * A tree with up to so many children a node, made from a binary one, in half the memory that {@link WideNodes} take: boxes are whole numbers of 16 bits, rounded outwards, on a grid that spans
 * the whole along each axis. With w children a node, half of which share their ints, the boxes of those of the node at n are the shorts of {@code data[n + wk/2 + slot/2]}, the lower half first,
 * k being minimum x y z, maximum x y z; slots without a child end before they begin. {@code data[n + 3w + slot]} names a child: where its node is if positive, else a leaf. The root is at
 * {@value #FIRST}. For who never asks for less than the whole.
 */
final class PackedNodes {
    /** Where the first node is: as in {@link WideNodes}. */
    static final int FIRST = WideNodes.FIRST;
    /** How many steps of the grid span the whole. */
    private static final double STEPS = 65_530;
    /**
     * How much finer than along the longest axis the grid is at most along another: more than floats tell apart would be of no use, and who looks at something flat from some way off would be too
     * many steps away to tell anything.
     */
    private static final double FINEST = 1 << 6;
    /** By so many steps boxes are larger, more than rounding changes. */
    private static final double MARGIN = 1e-6;
    /** A box whose surface grows by more than this is poor; one of so many may be. */
    private static final double POOR = 1.25;
    private static final int SOME = 8;

    int[] data = {};
    /** How many nodes lie from the root to the farthest leaf. */
    int depth;
    /** How many items there are. */
    int items;
    double centreX;
    double centreY;
    double centreZ;
    /** How many steps of the grid a unit takes along each axis. */
    double stepsX;
    double stepsY;
    double stepsZ;
    /** What values of t are multiplied by: a power of two, about the least of them. */
    double scale;
    /** How many children a node has room for: a multiple of two. */
    final int width;
    private final int stride;
    private int size = FIRST;
    private int children;
    private int poor;

    /** @param nodes more than one item */
    private PackedNodes(BinaryNodes nodes, int width) {
        this.width = width;
        this.stride = 4 * width;
        locate(nodes.boxes);
        reserve(1 + nodes.count() / (width - 2));
        widen(nodes, new Collapse(nodes, width), nodes.root, 1);
        data = Arrays.copyOf(data, size);
    }

    /** Packs a tree, unless it is but a leaf, or the grid too wide for many of its boxes: those of something small and detailed on a wide floor, say. */
    static Optional<PackedNodes> of(BinaryNodes nodes, int width) {
        if (nodes.depth == 0 || nodes.root < 0) {
            return Optional.empty();
        }
        PackedNodes packed = new PackedNodes(nodes, width);
        return packed.poor > packed.children / SOME ? Optional.empty() : Optional.of(packed);
    }

    private void locate(double[] boxes) {
        double[] extent = new double[3];
        double longest = 0;
        for (int k = 0; k < 3; k++) {
            extent[k] = Math.max(boxes[k + 3], boxes[k + 9]) - Math.min(boxes[k], boxes[k + 6]);
            longest = Math.max(longest, extent[k]);
        }
        double least = longest > 0 ? STEPS / longest : 1;
        centreX = middle(boxes, 0);
        centreY = middle(boxes, 1);
        centreZ = middle(boxes, 2);
        stepsX = Math.min(FINEST * least, STEPS / extent[0]);
        stepsY = Math.min(FINEST * least, STEPS / extent[1]);
        stepsZ = Math.min(FINEST * least, STEPS / extent[2]);
        scale = Math.scalb(1.0, Math.getExponent(least));
    }

    private static double middle(double[] boxes, int k) {
        return Math.max(boxes[k + 3], boxes[k + 9]) / 2 + Math.min(boxes[k], boxes[k + 6]) / 2;
    }

    private int widen(BinaryNodes nodes, Collapse plan, int inner, int level) {
        nodes.stopIfAsked(inner);
        depth = Math.max(depth, level + 1);
        int node = add();
        int[] at = plan.children(inner);
        for (int slot = 0; slot < at.length; slot++) {
            int name = plan.name(at[slot]);
            put(node, slot, nodes.boxes, at[slot]);
            if (name < 0) {
                items = Math.max(items, Tree.end(name));
            }
            int named = name < 0 ? name : widen(nodes, plan, name, level + 1);
            data[node + 3 * width + slot] = named;
        }
        return node;
    }

    private int add() {
        int node = size;
        size = Math.addExact(size, stride);
        if (size > data.length) {
            reserve(size / stride + size / stride / 4 + 1);
        }
        Arrays.fill(data, node, node + 3 * width / 2, Short.MAX_VALUE << 16 | Short.MAX_VALUE);
        Arrays.fill(data, node + 3 * width / 2, node + 3 * width, Short.MIN_VALUE << 16 | (Short.MIN_VALUE & 0xFFFF));
        return node;
    }

    private void reserve(int count) {
        data = Arrays.copyOf(data, FIRST + stride * count);
    }

    /** Writes the box that begins at {@code at} as that of a child. */
    private void put(int node, int slot, double[] boxes, int at) {
        double x = put(node, slot, 0, (boxes[at] - centreX) * stepsX, (boxes[at + 3] - centreX) * stepsX);
        double y = put(node, slot, 1, (boxes[at + 1] - centreY) * stepsY, (boxes[at + 4] - centreY) * stepsY);
        double z = put(node, slot, 2, (boxes[at + 2] - centreZ) * stepsZ, (boxes[at + 5] - centreZ) * stepsZ);
        children++;
        double dx = boxes[at + 3] - boxes[at];
        double dy = boxes[at + 4] - boxes[at + 1];
        double dz = boxes[at + 5] - boxes[at + 2];
        x /= stepsX;
        y /= stepsY;
        z /= stepsZ;
        poor += x * y + y * z + z * x > POOR * (dx * dy + dy * dz + dz * dx) ? 1 : 0;
    }

    /** Writes where a box is along an axis, and returns over how many steps that goes. */
    private int put(int node, int slot, int axis, double low, double high) {
        int from = (int) Math.floor(low - MARGIN);
        int to = (int) Math.ceil(high + MARGIN);
        set(node + axis * width / 2 + slot / 2, slot, from);
        set(node + (axis + 3) * width / 2 + slot / 2, slot, to);
        return to - from;
    }

    private void set(int at, int slot, int value) {
        data[at] = slot % 2 == 0 ? (data[at] & 0xFFFF0000) | (value & 0xFFFF) : (data[at] & 0xFFFF) | value << 16;
    }

    /** How many nodes and leaves are ever left to visit at once. */
    int mostToVisit() {
        return (width - 1) * depth + width;
    }
}
