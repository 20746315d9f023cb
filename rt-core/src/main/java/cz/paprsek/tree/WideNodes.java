package cz.paprsek.tree;

import java.util.Arrays;

/**
 * A tree with up to {@value #MOST} children a node, or fewer, made from a binary one. All is in one array, so that what is asked of a node is read from one place. With w
 * children a node, the boxes of those of the node at n are {@code data[n + wk + lane]}, k being minimum x y z, maximum x y z: relative to a centre, multiplied by a power of two
 * that brings them between −1 and 1, and rounded outwards to floats. Slots without a child are no number, whose bits are more than those of any t, so that nothing meets them. The bits of {@code data[n + 6w + slot]}
 * name a child: where its node is if positive, else a leaf. Nodes stand in the first slots, and side by side in the array, so that where the first is tells where all are;
 * how many they are, the bits of {@code data[n + 7w]} tell, see {@link #inner}. The root is at {@value #FIRST} even if it has but one child.
 */
final class WideNodes {
    /** The most children of any node. */
    static final int MOST = 16;
    /** Numbers a node takes, for each of its children: those of its box, its name, and one of which the node has the first. */
    static final int EACH = 8;
    /** Where the first node is: behind the head of the array that is where a line of the cache begins, if the array begins at one. */
    static final int FIRST = 12;

    float[] data = {};
    /** How many nodes lie from the root to the farthest leaf. */
    int depth;
    double centreX;
    double centreY;
    double centreZ;
    double scale = 1;
    /** How many children a node has room for, and numbers it takes. */
    final int width;
    final int stride;
    /** How much of it is taken. */
    private int size = FIRST;

    /** Makes it from a binary tree. */
    WideNodes(BinaryNodes nodes, int width) {
        this.width = width;
        this.stride = EACH * width;
        if (nodes.depth > 0 && nodes.root < 0) {
            // Nothing is known of the box of the only leaf; whoever asks the tree is likely to meet it.
            int node = add();
            data[node + 7 * width] = Float.intBitsToFloat(inner(width, 0));
            fill(node, 0, nodes.root, Float.NEGATIVE_INFINITY, Float.POSITIVE_INFINITY);
            this.depth = 1;
        } else if (nodes.depth > 0) {
            locate(nodes.boxes);
            // About so many it takes: a node of eight opens six or seven of the binary ones.
            reserve(1 + nodes.count() / (width - 2));
            widen(nodes, new Collapse(nodes, width), nodes.root, add(), 1);
        }
        data = Arrays.copyOf(data, size);
    }

    /** Centres on the smaller child of the root: floats tell apart best what lies near zero, and the larger may be a wide floor. */
    private void locate(double[] boxes) {
        centreX = (boxes[6] + boxes[9]) / 2;
        centreY = (boxes[7] + boxes[10]) / 2;
        centreZ = (boxes[8] + boxes[11]) / 2;
        double most = 0;
        for (int b = 0; b < 12; b += 3) {
            most = Math.max(most, Math.max(Math.abs(boxes[b] - centreX), Math.max(Math.abs(boxes[b + 1] - centreY), Math.abs(boxes[b + 2] - centreZ))));
        }
        scale = most > 0 ? Math.scalb(1.0, -Math.getExponent(most) - 1) : 1;
    }

    /** Fills a node with what the plan says are the children of an inner node of the binary tree. */
    private void widen(BinaryNodes nodes, Collapse plan, int from, int node, int level) {
        nodes.stopIfAsked(from);
        depth = Math.max(depth, level + 1);
        int[] at = plan.children(from);
        int first = size;
        int count = 0;
        for (int child : at) {
            if (plan.name(child) >= 0) {
                name(node, count, add());
                put(node, count++, nodes.boxes, child);
            }
        }
        data[node + 7 * width] = Float.intBitsToFloat(inner(width, count));
        for (int child : at) {
            if (plan.name(child) < 0) {
                name(node, count, plan.name(child));
                put(node, count++, nodes.boxes, child);
            }
        }
        for (int child : at) {
            if (plan.name(child) >= 0) {
                widen(nodes, plan, plan.name(child), first, level + 1);
                first += stride;
            }
        }
    }

    /**
     * Where in vectors a child stands. Of sixteen, a comparison makes two longs of a byte for each, which are put into one in turn: children whose bits follow one
     * another there have lanes of the one half and of the other.
     */
    static int lane(int width, int slot) {
        return width == 16 ? slot >> 1 | (slot & 1) << 3 : slot;
    }

    /** Which child stands in a lane. */
    static int slot(int width, int lane) {
        return width == 16 ? (lane & 7) << 1 | lane >> 3 : lane;
    }

    /**
     * By what {@code -1L} is shifted to the right to leave the bits of so many children, if those of all fill a long: to be shifted twice, since
     * there is no shift by 64.
     */
    private static int inner(int width, int count) {
        return 32 / width * (width - count);
    }

    private int add() {
        int node = size;
        size = Math.addExact(size, stride);
        if (size > data.length) {
            reserve(size / stride + size / stride / 4 + 1);
        }
        for (int slot = 0; slot < width; slot++) {
            fill(node, slot, 0, Float.NaN, Float.NaN);
        }
        return node;
    }

    private void reserve(int count) {
        data = Arrays.copyOf(data, FIRST + stride * count);
    }

    private void fill(int node, int slot, int name, float low, float high) {
        name(node, slot, name);
        for (int k = 0; k < 3; k++) {
            data[node + width * k + lane(width, slot)] = low;
            data[node + width * (k + 3) + lane(width, slot)] = high;
        }
    }

    private void name(int node, int slot, int name) {
        data[node + 6 * width + slot] = Float.intBitsToFloat(name);
    }

    private int name(int node, int slot) {
        return Float.floatToRawIntBits(data[node + 6 * width + slot]);
    }

    /** Writes the box that begins at {@code at} as that of a child. */
    private void put(int node, int slot, double[] boxes, int at) {
        int to = node + lane(width, slot);
        data[to] = below((boxes[at] - centreX) * scale);
        data[to + width] = below((boxes[at + 1] - centreY) * scale);
        data[to + 2 * width] = below((boxes[at + 2] - centreZ) * scale);
        data[to + 3 * width] = above((boxes[at + 3] - centreX) * scale);
        data[to + 4 * width] = above((boxes[at + 4] - centreY) * scale);
        data[to + 5 * width] = above((boxes[at + 5] - centreZ) * scale);
    }

    /** How many nodes and leaves are ever left to visit at once. */
    int mostToVisit() {
        return (width - 1) * depth + width;
    }

    /** The nearest inner node of the entries is opened again and again until all are leaves, or there would be too many. */
    void open(Bundle bundle, Entries entries) {
        double shortest = bundle.shortest();
        double unit = 1 / scale;
        int i = 0;
        while (i < entries.size) {
            int node = entries.node[i];
            if (node < 0 || !entries.haveRoomFor(width)) {
                i++;
                continue;
            }
            entries.remove(i);
            for (int slot = 0; slot < width && name(node, slot) != 0; slot++) {
                int subtree = name(node, slot);
                int at = node + lane(width, slot);
                double near = enter(bundle, at, unit);
                if (near < Double.POSITIVE_INFINITY) {
                    entries.add(subtree, Tree.isQuick(subtree) ? Entries.ANYWHERE : at, near * shortest);
                }
            }
        }
    }

    /** As {@link Bundle#enter}, of the child whose box begins at {@code at}; {@code unit} is 1 over the scale, a power of two. */
    private double enter(Bundle bundle, int at, double unit) {
        return bundle.enter(
                data[at] * unit + centreX, data[at + width] * unit + centreY, data[at + 2 * width] * unit + centreZ,
                data[at + 3 * width] * unit + centreX, data[at + 4 * width] * unit + centreY, data[at + 5 * width] * unit + centreZ);
    }

    private static float below(double x) {
        return Math.nextDown((float) x);
    }

    private static float above(double x) {
        return Math.nextUp((float) x);
    }
}
