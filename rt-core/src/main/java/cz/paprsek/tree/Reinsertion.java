package cz.paprsek.tree;

import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Betters a tree that was built from above, in place: takes each of the subtrees with the largest boxes out and puts it back where boxes grow least. Below those, which are most
 * of what a ray meets of a poor tree, all stays as it was; so the time is bounded however large the tree is. Scratch of building.
 *
 * @source Bittner, Hapala, Havran, Fast Insertion-Based Optimization of Bounding Volume Hierarchies, Computer Graphics Forum 32(1), 2013
 */
final class Reinsertion {
    /** A tree of fewer items is left as it is: this would be most of the time it takes to prepare it. */
    static final int LEAST = 4096;

    /** So many nodes are opened at most, which makes up to twice as many subtrees, less one. */
    private static final int MOST = 1 << 13;
    /** So many places are looked at for each, on the average, at most, in all passes together: with more, trees that were built from above are no better. */
    private static final int STEPS = 24;
    private static final int PASSES = 2;
    /** What is not cheaper elsewhere than so much of what it costs where it is stays there. */
    private static final double WORTH = 0.97;
    /** A tree is good enough if, once this part of its subtrees was tried, less than this part of those tried was moved. */
    private static final int FEW = 16;
    /** Trees that would become deeper stay as they were. */
    private static final int DEEPEST = TreeBuilder.STEEP + 34;

    private final double[] nodes;
    private final int[] child;
    private final int[] items;
    private final BooleanSupplier stop;

    /** Subtrees, the root first: the box of each, what it is called in the tree, in which one it is, and its two children if they are among these, else 0. */
    private final double[] box;
    /** Half the surface of each box. */
    private final double[] area;
    private final int[] name;
    private final int[] parent;
    private final int[] first;
    private final int[] second;
    private int count = 1;

    /** A heap of subtrees, that with the least key on top. */
    private double[] key;
    private int[] heap;
    private int waiting;
    /** The least that it costs to put back what was taken out, as far as is known, and beside which one. */
    private double best;
    private int beside;
    /** How many places may still be looked at. */
    private int steps;

    /** What was found below a node: items in neighbouring places. */
    private int low;
    private int high;
    /** Where the next items go. */
    private int place;

    /**
     * @param nodes boxes, as {@link BinaryNodes} has them
     * @param child names; the root is inner node 0
     * @param items in the order of the leaves
     * @param stop whether to give up
     */
    Reinsertion(double[] nodes, int[] child, int[] items, BooleanSupplier stop) {
        this.nodes = nodes;
        this.child = child;
        this.items = items;
        this.stop = stop;
        int room = 2 * Math.min(MOST, child.length / 2 + 1);
        box = new double[6 * room];
        area = new double[room];
        name = new int[room];
        parent = new int[room];
        first = new int[room];
        second = new int[room];
        key = new double[room];
        heap = new int[room];
        Grid.empty(box, 0);
        Grid.grow(box, 0, nodes, 0);
        Grid.grow(box, 0, nodes, 6);
        measure(0);
        parent[0] = -1;
        push(0, 0);
        while (waiting > 0 && count + 2 <= room) {
            open(pop());
        }
    }

    private void open(int subtree) {
        first[subtree] = add(subtree, 2 * name[subtree]);
        second[subtree] = add(subtree, 2 * name[subtree] + 1);
    }

    private int add(int in, int place) {
        int subtree = count++;
        parent[subtree] = in;
        name[subtree] = child[place];
        System.arraycopy(nodes, 6 * place, box, 6 * subtree, 6);
        measure(subtree);
        if (name[subtree] >= 0) {
            push(-area[subtree], subtree);
        }
        return subtree;
    }

    /**
     * Does it; returns how many nodes lie from the root to the farthest leaf then.
     *
     * @throws java.util.concurrent.CancellationException if it was to stop
     */
    int run(int depth) {
        steps = STEPS * count;
        int moved = pass();
        if (moved < 0) {
            return depth;
        }
        for (int pass = 1; pass < PASSES && steps > 0 && FEW * moved >= count; pass++) {
            moved = pass();
        }
        int deepest = 0;
        for (int i = 0; i < count; i++) {
            if (first[i] == 0) {
                int level = levels(name[i]);
                for (int up = parent[i]; up >= 0; up = parent[up]) {
                    level++;
                }
                deepest = Math.max(deepest, level);
            }
        }
        if (deepest > DEEPEST) {
            return depth;
        }
        write(0, items.clone());
        return deepest;
    }

    /** Tries all once, the largest first, and returns how many were moved; −1 if it gave up. */
    private int pass() {
        long[] order = new long[count - 1];
        for (int i = 1; i < count; i++) {
            order[i - 1] = ~(Double.doubleToRawLongBits(area[i]) >>> 32) << 32 | i;
        }
        Arrays.sort(order);
        int moved = 0;
        for (int i = 0; i < order.length && steps > 0; i++) {
            TreeBuilder.stopIfAsked(i, stop);
            if (FEW * i >= count && FEW * moved < i) {
                return -1;
            }
            moved += move((int) order[i]) ? 1 : 0;
        }
        return moved;
    }

    /** Takes a subtree out and puts it where it costs least, if that is clearly less than where it was; whether it is. */
    private boolean move(int subtree) {
        int pair = parent[subtree];
        int in = parent[pair];
        if (in < 0) {
            return false;
        }
        int sibling = first[pair] == subtree ? second[pair] : first[pair];
        replace(in, pair, sibling);
        double cost = area[pair] + shrink(in);
        cheapest(subtree, cost * WORTH);
        if (beside < 0) {
            replace(in, sibling, pair);
            parent[sibling] = pair;
            stretch(in, subtree);
            return false;
        }
        replace(parent[beside], beside, pair);
        first[pair] = beside;
        second[pair] = subtree;
        parent[beside] = pair;
        System.arraycopy(box, 6 * beside, box, 6 * pair, 6);
        Grid.grow(box, 6 * pair, box, 6 * subtree);
        measure(pair);
        stretch(parent[pair], subtree);
        return true;
    }

    /** Finds beside which one it costs least to put a subtree, if that is less than so much; else −1. */
    private void cheapest(int subtree, double most) {
        double own = area[subtree];
        best = most;
        beside = -1;
        waiting = 0;
        tryInside(0, halfAreaOfBoth(0, subtree) - area[0], own);
        while (waiting > 0 && key[0] + own < best) {
            double before = key[0];
            int at = pop();
            tryBeside(first[at], subtree, before);
            tryBeside(second[at], subtree, before);
        }
    }

    private void tryBeside(int at, int subtree, double before) {
        steps--;
        double all = before + halfAreaOfBoth(at, subtree);
        if (all < best) {
            best = all;
            beside = at;
        }
        if (first[at] != 0) {
            tryInside(at, all - area[at], area[subtree]);
        }
    }

    private void tryInside(int at, double growth, double own) {
        if (growth + own < best) {
            push(growth, at);
        }
    }

    private void replace(int in, int old, int by) {
        if (first[in] == old) {
            first[in] = by;
        } else {
            second[in] = by;
        }
        parent[by] = in;
    }

    /** Makes boxes fit what they still hold, from one upwards; by how much all of their surfaces lessen. */
    private double shrink(int from) {
        double sum = 0;
        for (int at = from; at >= 0; at = parent[at]) {
            int a = 6 * first[at];
            int b = 6 * second[at];
            boolean same = true;
            for (int k = 0; k < 3; k++) {
                double min = Math.min(box[a + k], box[b + k]);
                double max = Math.max(box[a + k + 3], box[b + k + 3]);
                same &= box[6 * at + k] == min && box[6 * at + k + 3] == max;
                box[6 * at + k] = min;
                box[6 * at + k + 3] = max;
            }
            if (same) {
                break;
            }
            double before = area[at];
            measure(at);
            sum += before - area[at];
        }
        return sum;
    }

    /** Makes boxes hold a subtree, from one upwards. */
    private void stretch(int from, int subtree) {
        for (int at = from; at >= 0 && !holds(at, subtree); at = parent[at]) {
            Grid.grow(box, 6 * at, box, 6 * subtree);
            measure(at);
        }
    }

    private boolean holds(int one, int other) {
        boolean all = true;
        for (int k = 0; k < 3; k++) {
            all &= box[6 * one + k] <= box[6 * other + k] && box[6 * one + k + 3] >= box[6 * other + k + 3];
        }
        return all;
    }

    private void measure(int subtree) {
        area[subtree] = halfAreaOfBoth(subtree, subtree);
    }

    /** Half the surface of the box around two. */
    private double halfAreaOfBoth(int one, int other) {
        int a = 6 * one;
        int b = 6 * other;
        double x = Math.max(box[a + 3], box[b + 3]) - Math.min(box[a], box[b]);
        double y = Math.max(box[a + 4], box[b + 4]) - Math.min(box[a + 1], box[b + 1]);
        double z = Math.max(box[a + 5], box[b + 5]) - Math.min(box[a + 2], box[b + 2]);
        return x * y + y * z + z * x;
    }

    private void push(double itsKey, int subtree) {
        int at = waiting++;
        for (; at > 0 && key[(at - 1) / 2] > itsKey; at = (at - 1) / 2) {
            key[at] = key[(at - 1) / 2];
            heap[at] = heap[(at - 1) / 2];
        }
        key[at] = itsKey;
        heap[at] = subtree;
    }

    private int pop() {
        int top = heap[0];
        waiting--;
        int at = 0;
        for (int below = 1; below < waiting; below = 2 * at + 1) {
            if (below + 1 < waiting && key[below + 1] < key[below]) {
                below++;
            }
            if (key[below] >= key[waiting]) {
                break;
            }
            key[at] = key[below];
            heap[at] = heap[below];
            at = below;
        }
        key[at] = key[waiting];
        heap[at] = heap[waiting];
        return top;
    }

    /** How many nodes lie one below another, a leaf included. */
    private int levels(int subtree) {
        return subtree < 0 ? 1 : 1 + Math.max(levels(child[2 * subtree]), levels(child[2 * subtree + 1]));
    }

    /** Writes it into the tree, and its items into the order of its leaves; returns its name. */
    private int write(int subtree, int[] old) {
        if (first[subtree] == 0) {
            low = Integer.MAX_VALUE;
            high = 0;
            span(name[subtree]);
            System.arraycopy(old, low, items, place, high - low);
            int by = place - low;
            place += high - low;
            return by == 0 ? name[subtree] : shift(name[subtree], by);
        }
        boolean firstIsLarger = area[first[subtree]] >= area[second[subtree]];
        int larger = firstIsLarger ? first[subtree] : second[subtree];
        int other = firstIsLarger ? second[subtree] : first[subtree];
        int node = name[subtree];
        System.arraycopy(box, 6 * larger, nodes, 12 * node, 6);
        System.arraycopy(box, 6 * other, nodes, 12 * node + 6, 6);
        child[2 * node] = write(larger, old);
        child[2 * node + 1] = write(other, old);
        return node;
    }

    private void span(int subtree) {
        if (subtree < 0) {
            low = Math.min(low, Tree.first(subtree));
            high = Math.max(high, Tree.end(subtree));
        } else {
            span(child[2 * subtree]);
            span(child[2 * subtree + 1]);
        }
    }

    /** Moves all leaves of a subtree by so many places; returns its name. */
    private int shift(int subtree, int by) {
        if (subtree < 0) {
            return Tree.moved(subtree, by);
        }
        child[2 * subtree] = shift(child[2 * subtree], by);
        child[2 * subtree + 1] = shift(child[2 * subtree + 1], by);
        return subtree;
    }
}
