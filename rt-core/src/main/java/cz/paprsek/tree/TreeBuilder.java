package cz.paprsek.tree;

import cz.paprsek.math.Bounds;
import java.util.concurrent.CancellationException;
import java.util.concurrent.RecursiveAction;
import java.util.function.BooleanSupplier;

/**
 * Builds the tree by the surface area heuristic: {@value #BINS} bins on each axis, all three in one pass, small records moved in place.
 * Subtrees above {@value #FORK} records are built in parallel; a subtree of n records owns the nodes from its base to base + n − 2, so
 * that tasks share nothing and the tree does not depend on the number of threads.
 *
 * @source Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007
 */
public final class TreeBuilder {
    /** The most bins; few records get one each. */
    private static final int BINS = 16;
    private static final int FORK = 4096;
    /** The cost of visiting a node in units of testing a surface, as measured: of a small tree, and of one of a million surfaces. */
    private static final double NEAR_NODE_COST = 1.5;
    private static final double FAR_NODE_COST = 6;
    /** Below this depth a split always halves, which bounds the depth of the tree whatever the scene. */
    private static final int STEEP = 48;

    /** How many records are dealt with between two questions whether to stop. */
    private static final int BATCH = 1024;

    /** The boxes of the records, six numbers each, and what each record is; both are permuted together. */
    private final double[] box;
    private final int[] record;
    /** By what a record is: the cost of testing it. */
    private final float[] cost;
    private final BooleanSupplier stop;
    private final double nodeCost;
    private final double[] boxes;
    private final int[] child;

    /**
     * Boxes and items are permuted together, into the order of the leaves.
     *
     * @param boxes a finite box for each item: its minimum x y z, its maximum x y z
     * @param items numbers, each its own
     * @param cost by an item's number: about how long it takes to meet a line, in units of what a sphere takes
     * @param stop whether to give up; asked now and then, by several threads
     */
    public TreeBuilder(double[] boxes, int[] items, float[] cost, BooleanSupplier stop) {
        this.box = boxes;
        this.record = items;
        this.cost = cost;
        this.stop = stop;
        // The larger the tree, the farther from the processor lie its nodes.
        this.nodeCost = Math.max(NEAR_NODE_COST, FAR_NODE_COST * StrictMath.cbrt(record.length / 1e6));
        int inner = Math.max(0, record.length - 1);
        this.boxes = new double[12 * inner];
        this.child = new int[2 * inner];
    }

    /** Writes a box into an array of boxes. */
    public static void put(double[] boxes, int i, Bounds bounds) {
        boxes[6 * i] = bounds.minX();
        boxes[6 * i + 1] = bounds.minY();
        boxes[6 * i + 2] = bounds.minZ();
        boxes[6 * i + 3] = bounds.maxX();
        boxes[6 * i + 4] = bounds.maxY();
        boxes[6 * i + 5] = bounds.maxZ();
    }

    /**
     * To be called with every number of a count while something is prepared: once in a while, asks whether to stop.
     *
     * @throws CancellationException if so
     */
    public static void stopIfAsked(int i, BooleanSupplier stop) {
        if (i % BATCH == 0 && stop.getAsBoolean()) {
            throw new CancellationException("the preparation of the scene was cancelled");
        }
    }

    /**
     * Builds the tree.
     *
     * @throws CancellationException if it was to stop
     */
    public Tree build() {
        if (record.length == 0) {
            return Kernel.suitedTo(0, 0).tree(boxes, child, 0, 0);
        }
        Subtree whole = new Subtree(0, record.length, 0, 0);
        whole.invoke();
        return Kernel.suitedTo(record.length, cost(0, record.length)).tree(boxes, child, whole.name, whole.depth);
    }

    /** One task: the records from {@code from} to {@code to} become a subtree with nodes from {@code base} on. */
    final class Subtree extends RecursiveAction {
        private static final long serialVersionUID = 1;

        private final int from;
        private final int to;
        private final int base;
        private final int level;
        /** The subtree's name as a child, and how many nodes lie below one another in it. */
        int name;
        int depth;

        Subtree(int from, int to, int base, int level) {
            this.from = from;
            this.to = to;
            this.base = base;
            this.level = level;
        }

        @Override
        protected void compute() {
            Bins bins = new Bins();
            name = build(from, to, base, level, bins);
        }

        private int build(int start, int end, int node, int at, Bins bins) {
            depth = Math.max(depth, at - level + 1);
            int count = end - start;
            int middle = count == 1 ? start : split(start, end, at, bins);
            if (middle == start) {
                return Tree.leaf(start, count, cost(start, end));
            }
            if (!bins.isPlane) {
                bins.halve(box, start, middle, end);
            }
            int larger = halfArea(bins.sides, 0) >= halfArea(bins.sides, 6) ? 0 : 1;
            System.arraycopy(bins.sides, 0, boxes, 12 * node + 6 * larger, 6);
            System.arraycopy(bins.sides, 6, boxes, 12 * node + 6 - 6 * larger, 6);
            int rightNode = node + middle - start;
            if (count > FORK) {
                Subtree left = new Subtree(start, middle, node + 1, at + 1);
                Subtree right = new Subtree(middle, end, rightNode, at + 1);
                invokeAll(left, right);
                child[2 * node + larger] = left.name;
                child[2 * node + 1 - larger] = right.name;
                depth = Math.max(depth, at - level + 1 + Math.max(left.depth, right.depth));
            } else {
                child[2 * node + larger] = build(start, middle, node + 1, at + 1, bins);
                child[2 * node + 1 - larger] = build(middle, end, rightNode, at + 1, bins);
            }
            return node;
        }
    }

    /** Parts the records in two and returns where the second begins; {@code start} if they had better stay one leaf. */
    private int split(int start, int end, int depth, Bins bins) {
        int count = end - start;
        bins.isPlane = false;
        if (depth < STEEP && bins.find(box, start, end, count)) {
            if (count <= Tree.LEAF && (count - bins.bestCost) * (cost(start, end) / count) <= nodeCost) {
                return start;
            }
            int middle = partition(start, end, bins);
            if (middle > start && middle < end) {
                bins.part();
                return middle;
            }
        }
        return count <= Tree.LEAF ? start : start + count / 2;
    }

    /** Half the surface of a box; 0 if it is empty. */
    static double halfArea(double[] boxes, int b) {
        double x = boxes[b + 3] - boxes[b];
        double y = boxes[b + 4] - boxes[b + 1];
        double z = boxes[b + 5] - boxes[b + 2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }

    private double cost(int start, int end) {
        double sum = 0;
        for (int i = start; i < end; i++) {
            sum += cost[record[i]];
        }
        return sum;
    }

    private int partition(int start, int end, Bins bins) {
        int a = start;
        int b = end - 1;
        while (a <= b) {
            stopIfAsked(b - a, stop);
            if (bins.bin(box, a, bins.bestAxis) < bins.bestBin) {
                a++;
            } else {
                swap(a, b--);
            }
        }
        return a;
    }

    private void swap(int a, int b) {
        int r = record[a];
        record[a] = record[b];
        record[b] = r;
        for (int k = 0; k < 6; k++) {
            double v = box[6 * a + k];
            box[6 * a + k] = box[6 * b + k];
            box[6 * b + k] = v;
        }
    }

    /** Scratch of one task: counts and boxes of the bins of all three axes, and the best plane found. */
    private final class Bins {
        private final int[] count = new int[3 * BINS];
        private final double[] box = new double[3 * BINS * 6];
        private final double[] low = new double[3];
        private final double[] scale = new double[3];
        private final double[] area = new double[BINS];
        /** The boxes of both sides of the last split. */
        final double[] sides = new double[12];
        private int bins;
        double bestCost;
        int bestAxis;
        int bestBin;
        /** Whether the last split was along a plane, so that bins tell the boxes of its sides. */
        boolean isPlane;

        /** Finds the plane of least cost; false if all centres coincide. Cost is in surface tests, given that the whole is hit. */
        boolean find(double[] records, int start, int end, int total) {
            reset(records, start, end);
            for (int i = start; i < end; i++) {
                stopIfAsked(i, stop);
                for (int axis = 0; axis < 3; axis++) {
                    int bin = axis * BINS + bin(records, i, axis);
                    count[bin]++;
                    grow(box, 6 * bin, records, 6 * i);
                }
            }
            bestCost = Double.POSITIVE_INFINITY;
            for (int axis = 0; axis < 3; axis++) {
                if (scale[axis] > 0) {
                    sweep(axis, total);
                }
            }
            return bestCost < Double.POSITIVE_INFINITY;
        }

        /** Which bin the record's centre falls into. */
        int bin(double[] records, int i, int axis) {
            double centre = records[6 * i + axis] + records[6 * i + axis + 3];
            return Math.min(bins - 1, (int) ((centre - low[axis]) * scale[axis]));
        }

        private void reset(double[] records, int start, int end) {
            bins = Math.max(4, Math.min(BINS, end - start));
            double lowX = Double.POSITIVE_INFINITY;
            double lowY = Double.POSITIVE_INFINITY;
            double lowZ = Double.POSITIVE_INFINITY;
            double highX = Double.NEGATIVE_INFINITY;
            double highY = Double.NEGATIVE_INFINITY;
            double highZ = Double.NEGATIVE_INFINITY;
            // In one pass, for large scenes do not fit into the cache. Not Math.min, here and below: a comparison that mostly goes one way costs far less.
            for (int i = 6 * start; i < 6 * end; i += 6) {
                double x = records[i] + records[i + 3];
                double y = records[i + 1] + records[i + 4];
                double z = records[i + 2] + records[i + 5];
                lowX = x < lowX ? x : lowX;
                lowY = y < lowY ? y : lowY;
                lowZ = z < lowZ ? z : lowZ;
                highX = x > highX ? x : highX;
                highY = y > highY ? y : highY;
                highZ = z > highZ ? z : highZ;
            }
            reset(0, lowX, highX);
            reset(1, lowY, highY);
            reset(2, lowZ, highZ);
        }

        private void reset(int axis, double least, double most) {
            low[axis] = least;
            scale[axis] = most > least ? Math.min(bins / (most - least), Double.MAX_VALUE) : 0;
            for (int bin = axis * BINS; bin < axis * BINS + bins; bin++) {
                count[bin] = 0;
                empty(box, 6 * bin);
            }
        }

        /** Finds the boxes of the two sides of the best plane. */
        void part() {
            isPlane = true;
            empty(sides, 0);
            empty(sides, 6);
            for (int bin = 0; bin < bins; bin++) {
                grow(sides, bin < bestBin ? 0 : 6, box, 6 * (bestAxis * BINS + bin));
            }
        }

        /** Finds the boxes of two runs of records. */
        void halve(double[] records, int start, int middle, int end) {
            empty(sides, 0);
            empty(sides, 6);
            for (int i = start; i < end; i++) {
                grow(sides, i < middle ? 0 : 6, records, 6 * i);
            }
        }

        private void sweep(int axis, int total) {
            int first = axis * BINS;
            empty(sides, 0);
            for (int bin = bins - 1; bin > 0; bin--) {
                grow(sides, 0, box, 6 * (first + bin));
                area[bin] = halfArea(sides, 0);
            }
            empty(sides, 0);
            int left = 0;
            double best = Double.POSITIVE_INFINITY;
            int at = 0;
            for (int bin = 1; bin < bins; bin++) {
                grow(sides, 0, box, 6 * (first + bin - 1));
                left += count[first + bin - 1];
                if (left > 0 && left < total) {
                    double cost = halfArea(sides, 0) * left + area[bin] * (total - left);
                    if (cost < best) {
                        best = cost;
                        at = bin;
                    }
                }
            }
            grow(sides, 0, box, 6 * (first + bins - 1));
            double whole = halfArea(sides, 0);
            double cost = whole > 0 ? best / whole : best < Double.POSITIVE_INFINITY ? total : best;
            if (cost < bestCost) {
                bestCost = cost;
                bestAxis = axis;
                bestBin = at;
            }
        }

        private static void empty(double[] boxes, int at) {
            for (int k = 0; k < 3; k++) {
                boxes[at + k] = Double.POSITIVE_INFINITY;
                boxes[at + k + 3] = Double.NEGATIVE_INFINITY;
            }
        }

        private static void grow(double[] boxes, int at, double[] by, int from) {
            for (int k = 0; k < 3; k++) {
                if (by[from + k] < boxes[at + k]) {
                    boxes[at + k] = by[from + k];
                }
                if (by[from + k + 3] > boxes[at + k + 3]) {
                    boxes[at + k + 3] = by[from + k + 3];
                }
            }
        }
    }
}
