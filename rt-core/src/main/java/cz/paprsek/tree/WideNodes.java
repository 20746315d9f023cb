package cz.paprsek.tree;

import java.util.Arrays;

/**
 * A tree with up to {@value #WIDTH} children a node, made from a binary one. Of node n, {@code planes[48n + 8k + slot]} holds the boxes of the
 * children, k being minimum x y z, maximum x y z: relative to a centre, multiplied by a power of two that brings them between −1 and 1, and
 * rounded outwards to floats. Slots without a child are +∞ and −∞, so that nothing meets them. {@code child[8n + slot]} names a child: an
 * inner node if positive, else a leaf. The root is node 0 even if it has but one child.
 */
final class WideNodes {
    /** The most children of a node. */
    static final int WIDTH = 8;
    /** Numbers a node takes in {@link #planes}. */
    static final int STRIDE = 6 * WIDTH;

    float[] planes = {};
    int[] child = {};
    /** How many nodes lie from the root to the farthest leaf. */
    int depth;
    double centreX;
    double centreY;
    double centreZ;
    double scale = 1;
    private int size;

    /** The binary tree; let go of once all is made. */
    private double[] boxes;
    private int[] binary;

    /** Makes it from a binary tree as {@link BinaryTree} has it. */
    WideNodes(double[] boxes, int[] child, int root, int depth) {
        this.boxes = boxes;
        this.binary = child;
        if (depth > 0 && root < 0) {
            // Nothing is known of the box of the only leaf; whoever asks the tree is likely to meet it.
            int node = add();
            fill(node, 0, root, Float.NEGATIVE_INFINITY, Float.POSITIVE_INFINITY);
            this.depth = 1;
        } else if (depth > 0) {
            locate();
            // About so many it takes: a node opens four or five of the binary ones.
            reserve(1 + child.length / 9);
            widen(root, 1);
        }
        planes = Arrays.copyOf(planes, STRIDE * size);
        this.child = Arrays.copyOf(this.child, WIDTH * size);
        this.boxes = new double[0];
        this.binary = new int[0];
    }

    /** Centres on the smaller child of the root: floats tell apart best what lies near zero, and the larger may be a wide floor. */
    private void locate() {
        centreX = (boxes[6] + boxes[9]) / 2;
        centreY = (boxes[7] + boxes[10]) / 2;
        centreZ = (boxes[8] + boxes[11]) / 2;
        double most = 0;
        for (int b = 0; b < 12; b += 3) {
            most = Math.max(most, Math.max(Math.abs(boxes[b] - centreX), Math.max(Math.abs(boxes[b + 1] - centreY), Math.abs(boxes[b + 2] - centreZ))));
        }
        scale = most > 0 ? Math.scalb(1.0, -Math.getExponent(most) - 1) : 1;
    }

    private int widen(int root, int level) {
        depth = Math.max(depth, level + 1);
        int node = add();
        // Where in boxes each child's box lies; half of that over three is where its name is.
        int[] at = new int[WIDTH];
        int count = 2;
        at[0] = 12 * root;
        at[1] = 12 * root + 6;
        while (count < WIDTH) {
            int largest = -1;
            double most = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < count; i++) {
                double area = binary[at[i] / 6] < 0 ? Double.NEGATIVE_INFINITY : halfArea(at[i]);
                if (area > most) {
                    most = area;
                    largest = i;
                }
            }
            if (largest < 0) {
                break;
            }
            int opened = binary[at[largest] / 6];
            at[largest] = 12 * opened;
            at[count++] = 12 * opened + 6;
        }
        for (int slot = 0; slot < count; slot++) {
            int name = binary[at[slot] / 6];
            int named = name < 0 ? name : widen(name, level + 1);
            child[WIDTH * node + slot] = named;
            put(node, slot, at[slot]);
        }
        return node;
    }

    /** Half the surface of a box. */
    private double halfArea(int b) {
        double x = boxes[b + 3] - boxes[b];
        double y = boxes[b + 4] - boxes[b + 1];
        double z = boxes[b + 5] - boxes[b + 2];
        return x * y + y * z + z * x;
    }

    private int add() {
        if (size * WIDTH == child.length) {
            reserve(size + size / 4 + 1);
        }
        for (int slot = 0; slot < WIDTH; slot++) {
            fill(size, slot, 0, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY);
        }
        return size++;
    }

    private void reserve(int count) {
        planes = Arrays.copyOf(planes, STRIDE * count);
        child = Arrays.copyOf(child, WIDTH * count);
    }

    private void fill(int node, int slot, int name, float low, float high) {
        child[WIDTH * node + slot] = name;
        for (int k = 0; k < 3; k++) {
            planes[STRIDE * node + WIDTH * k + slot] = low;
            planes[STRIDE * node + WIDTH * (k + 3) + slot] = high;
        }
    }

    /** Writes the box at {@code at} as that of a child. */
    private void put(int node, int slot, int at) {
        int to = STRIDE * node + slot;
        planes[to] = below((boxes[at] - centreX) * scale);
        planes[to + WIDTH] = below((boxes[at + 1] - centreY) * scale);
        planes[to + 2 * WIDTH] = below((boxes[at + 2] - centreZ) * scale);
        planes[to + 3 * WIDTH] = above((boxes[at + 3] - centreX) * scale);
        planes[to + 4 * WIDTH] = above((boxes[at + 4] - centreY) * scale);
        planes[to + 5 * WIDTH] = above((boxes[at + 5] - centreZ) * scale);
    }

    /** How many nodes and leaves are ever left to visit at once. */
    int mostToVisit() {
        return (WIDTH - 1) * depth + WIDTH;
    }

    /** As {@link Bundle#enter}, of the child whose planes begin at {@code at}. */
    double enter(Bundle bundle, int at) {
        return bundle.enter(
                planes[at] / scale + centreX, planes[at + WIDTH] / scale + centreY, planes[at + 2 * WIDTH] / scale + centreZ,
                planes[at + 3 * WIDTH] / scale + centreX, planes[at + 4 * WIDTH] / scale + centreY, planes[at + 5 * WIDTH] / scale + centreZ);
    }

    private static float below(double x) {
        return Math.nextDown((float) x);
    }

    private static float above(double x) {
        return Math.nextUp((float) x);
    }
}
