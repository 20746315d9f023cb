package cz.paprsek.tree;

import cz.paprsek.math.Bounds;
import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.concurrent.RecursiveAction;
import java.util.function.BooleanSupplier;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * Builds the tree by the surface area heuristic. Where to part items is decided by {@link Bins} of coarse records, which are moved in place; the boxes
 * of nodes are those of the items, to the last bit. Subtrees above {@value #FORK} items are built in parallel, and each keeps its nodes for
 * itself until all are put together: tasks share nothing, the tree does not depend on the number of threads, and there are no more
 * nodes than it has.
 *
 * @source Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007
 */
public final class TreeBuilder {
    /** Below this depth a split always halves, which bounds the depth of the tree whatever the scene. */
    static final int STEEP = 48;
    private static final int FORK = 4096;
    /** The cost of visiting a node in units of testing a surface, as measured: of a small tree, and of one of a million surfaces. */
    private static final double NEAR_NODE_COST = 1.5;
    private static final double FAR_NODE_COST = 6;

    /** How many records are dealt with between two questions whether to stop: a power of two. */
    private static final int BATCH = 1024;

    private final ItemBoxes boxes;
    private final int[] items;
    /** By an item's number: the cost of testing it. */
    private final float[] cost;
    /** What all items cost together, and whether each of them costs the same. */
    private final double all;
    private final boolean alike;
    private final BooleanSupplier stop;
    private final double nodeCost;

    /**
     * Puts items into the order of the leaves.
     *
     * @param boxes tells the box of each item, the same whenever it is asked
     * @param items numbers, each its own
     * @param cost by an item's number: about how long it takes to meet a line, in units of what a sphere takes
     * @param stop whether to give up; asked now and then, by several threads
     */
    public TreeBuilder(ItemBoxes boxes, int[] items, float[] cost, BooleanSupplier stop) {
        this.boxes = boxes;
        this.items = items;
        this.cost = cost;
        this.stop = stop;
        // The larger the tree, the farther from the processor lie its nodes.
        this.nodeCost = Math.max(NEAR_NODE_COST, FAR_NODE_COST * StrictMath.cbrt(items.length / 1e6));
        // While neighbouring items still have neighbouring numbers: in the order of the leaves each would be looked for in memory.
        double sum = 0;
        boolean same = true;
        for (int item : items) {
            sum += cost[item];
            same &= cost[item] == cost[items[0]];
        }
        this.all = sum;
        this.alike = same;
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
        if ((i & (BATCH - 1)) == 0 && stop.getAsBoolean()) {
            throw new CancellationException("the preparation of the scene was cancelled");
        }
    }

    /**
     * Builds the tree.
     *
     * @throws CancellationException if it was to stop
     */
    public Tree build() {
        BinaryNodes nodes = nodes();
        return Kernel.suitedTo(items.length, all).tree(nodes);
    }

    /**
     * Builds the tree for who always searches the {@linkplain Tree#whole whole}: no bundle leads anywhere in it, and it may take less memory.
     *
     * @throws CancellationException if it was to stop
     */
    public Tree buildWhole() {
        BinaryNodes nodes = nodes();
        return Kernel.suitedTo(items.length, all).whole(nodes);
    }

    private BinaryNodes nodes() {
        int count = items.length;
        if (count == 0) {
            return new BinaryNodes(new double[0], new int[0], 0, 0, place -> 0, stop);
        }
        Subtree whole = new Subtree(count > FORK ? records() : new int[0], 0, count, 0, new int[0]);
        whole.invoke();
        double[] nodes = new double[12 * whole.count];
        int[] child = new int[2 * whole.count];
        int root = whole.write(0, nodes, child);
        int depth = root < 0 || count < Reinsertion.LEAST ? whole.depth : new Reinsertion(nodes, child, items, stop).run(whole.depth);
        return new BinaryNodes(nodes, child, root, depth, costs(), stop);
    }

    /** What the item at each place costs; mostly all cost the same, and nothing need be looked up. */
    private IntToDoubleFunction costs() {
        float one = cost[items[0]];
        return alike ? place -> one : place -> cost[items[place]];
    }

    /** The records of all items. */
    private int[] records() {
        int[] records = new int[6 * items.length];
        int parts = (items.length + FORK - 1) / FORK;
        double[] whole = IntStream.range(0, parts).parallel().mapToObj(part -> {
            double[] box = new double[12];
            Grid.empty(box, 6);
            for (int i = part * FORK; i < Math.min(items.length, (part + 1) * FORK); i++) {
                stopIfAsked(i, stop);
                boxes.put(items[i], box, 0);
                Grid.grow(box, 6, box, 0);
            }
            return Arrays.copyOfRange(box, 6, 12);
        }).reduce((a, b) -> {
            Grid.grow(a, 0, b, 0);
            return a;
        }).orElseThrow();
        Grid grid = new Grid(whole);
        IntStream.range(0, parts).parallel().forEach(part -> {
            double[] box = new double[6];
            for (int i = part * FORK; i < Math.min(items.length, (part + 1) * FORK); i++) {
                stopIfAsked(i, stop);
                boxes.put(items[i], box, 0);
                grid.put(box, 0, records, 6 * i);
            }
        });
        return records;
    }

    /** One task: the items from {@code from} to {@code to} become a subtree. */
    final class Subtree extends RecursiveAction {
        private static final long serialVersionUID = 1;

        private final int[] records;
        private final int from;
        private final int to;
        private final int level;
        /** The bounds of the records' centres, if they are known. */
        private final int[] centres;
        /** Its nodes, as a tree has them, with names that count from 0, parents first; only the root, if others build what lies below. */
        private double[] nodes = new double[12];
        private int[] child = new int[2];
        private @Nullable Subtree first;
        private @Nullable Subtree second;
        private int name;
        private final double[] box = new double[6];
        /** How many nodes there are, with those that others build; and how many lie below one another, leaves included. */
        int count;
        int depth;

        Subtree(int[] records, int from, int to, int level, int[] centres) {
            this.records = records;
            this.from = from;
            this.to = to;
            this.level = level;
            this.centres = centres;
        }

        @Override
        protected void compute() {
            if (to - from > FORK) {
                divide();
            } else {
                Branch branch = new Branch(from, to, level);
                branch.grow();
                nodes = branch.nodes;
                child = branch.child;
                count = branch.count;
                depth = branch.depth;
                name = branch.name;
                System.arraycopy(branch.box, 0, box, 0, 6);
            }
        }

        private void divide() {
            Bins bins = new Bins(records, items, stop);
            if (centres.length == 0) {
                bins.measure(from, to, 0);
            } else {
                bins.start(centres);
            }
            int middle = level < STEEP && bins.find(from, to, 0) ? bins.part(from, to, 0) : from;
            middle = middle > from && middle < to ? middle : bins.halve(from, to, 0);
            boolean leftFirst = bins.isLeftLarger(0);
            Subtree larger = new Subtree(records, leftFirst ? from : middle, leftFirst ? middle : to, level + 1, bins.centres(2));
            Subtree other = new Subtree(records, leftFirst ? middle : from, leftFirst ? to : middle, level + 1, bins.centres(1));
            invokeAll(larger, other);
            System.arraycopy(larger.box, 0, nodes, 0, 6);
            System.arraycopy(other.box, 0, nodes, 6, 6);
            System.arraycopy(larger.box, 0, box, 0, 6);
            Grid.grow(box, 0, other.box, 0);
            first = larger;
            second = other;
            count = 1 + larger.count + other.count;
            depth = 1 + Math.max(larger.depth, other.depth);
        }

        /** Writes the nodes, from a number on, where all are put together; returns the subtree's name. */
        int write(int at, double[] allNodes, int[] allChild) {
            Subtree below = first;
            if (below != null && second != null) {
                System.arraycopy(nodes, 0, allNodes, 12 * at, 12);
                allChild[2 * at] = below.write(at + 1, allNodes, allChild);
                allChild[2 * at + 1] = second.write(at + 1 + below.count, allNodes, allChild);
                return at;
            }
            System.arraycopy(nodes, 0, allNodes, 12 * at, 12 * count);
            for (int i = 0; i < 2 * count; i++) {
                allChild[2 * at + i] = child[i] < 0 ? child[i] : child[i] + at;
            }
            return name < 0 ? name : at;
        }
    }

    /** Few enough items for one thread, with records of their own: as fine as what they take of space needs. */
    private final class Branch {
        private final int from;
        private final int level;
        private final int[] own;
        private final double[] exact;
        /** Which of its items each record is. */
        private final int[] order;
        private final Bins bins;
        final double[] box = new double[6];
        double[] nodes = new double[12 * 64];
        int[] child = new int[2 * 64];
        int count;
        int depth;
        int name;

        Branch(int from, int to, int level) {
            this.from = from;
            this.level = level;
            own = Arrays.copyOfRange(items, from, to);
            exact = new double[6 * own.length];
            order = new int[own.length];
            Grid.empty(box, 0);
            for (int i = 0; i < own.length; i++) {
                order[i] = i;
                boxes.put(own[i], exact, 6 * i);
                Grid.grow(box, 0, exact, 6 * i);
            }
            int[] records = new int[6 * own.length];
            Grid grid = new Grid(box);
            for (int i = 0; i < own.length; i++) {
                grid.put(exact, 6 * i, records, 6 * i);
            }
            bins = new Bins(records, order, stop);
        }

        void grow() {
            bins.measure(0, own.length, 0);
            name = build(0, own.length, level, 0);
            for (int i = 0; i < own.length; i++) {
                items[from + i] = own[order[i]];
            }
        }

        private int build(int start, int end, int at, int frame) {
            depth = Math.max(depth, at - level + 1);
            int middle = split(start, end, at, frame);
            if (middle == start) {
                return Tree.leaf(from + start, end - start, cost(start, end));
            }
            boolean leftFirst = bins.isLeftLarger(frame);
            int node = add();
            int larger = leftFirst ? build(start, middle, at + 1, frame + 2) : build(middle, end, at + 1, frame + 2);
            int other = leftFirst ? build(middle, end, at + 1, frame + 1) : build(start, middle, at + 1, frame + 1);
            child[2 * node] = larger;
            child[2 * node + 1] = other;
            bound(larger, 12 * node);
            bound(other, 12 * node + 6);
            return node;
        }

        /** Parts the records in two and returns where the second begins; {@code start} if they had better stay one leaf. */
        private int split(int start, int end, int at, int frame) {
            int size = end - start;
            double all = size <= Tree.LEAF ? cost(start, end) : Double.POSITIVE_INFINITY;
            // Nothing is gained by a plane that no node could be cheaper than.
            if (size == 1 || all <= nodeCost) {
                return start;
            }
            if (at < STEEP && bins.find(start, end, frame)) {
                if (size <= Tree.LEAF && (size - bins.cost()) * (all / size) <= nodeCost) {
                    return start;
                }
                int middle = bins.part(start, end, frame);
                if (middle > start && middle < end) {
                    return middle;
                }
            }
            return size <= Tree.LEAF ? start : bins.halve(start, end, frame);
        }

        private double cost(int start, int end) {
            double sum = 0;
            for (int i = start; i < end; i++) {
                sum += cost[own[order[i]]];
            }
            return sum;
        }

        private int add() {
            if (2 * count == child.length) {
                nodes = Arrays.copyOf(nodes, 2 * nodes.length);
                child = Arrays.copyOf(child, 2 * child.length);
            }
            return count++;
        }

        /** Writes the box of what has a name. */
        private void bound(int subtree, int to) {
            Grid.empty(nodes, to);
            if (subtree >= 0) {
                Grid.grow(nodes, to, nodes, 12 * subtree);
                Grid.grow(nodes, to, nodes, 12 * subtree + 6);
            } else {
                for (int i = Tree.first(subtree) - from; i < Tree.end(subtree) - from; i++) {
                    Grid.grow(nodes, to, exact, 6 * order[i]);
                }
            }
        }
    }
}
