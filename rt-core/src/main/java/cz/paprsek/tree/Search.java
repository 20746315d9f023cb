package cz.paprsek.tree;

import org.jspecify.annotations.Nullable;

/**
 * Scratch of one worker: a line o + t·d as trees ask about boxes, the nodes still to be visited, and what is done at the leaves.
 *
 * @param <R> the ray that searches: only who looks at the leaves knows it. It is handed through rather than kept, because writing a
 *         reference for every ray costs more than it seems: the collector wants to know.
 */
public abstract class Search<R> {
    /** Of so many leaves it is enough to ask at once. */
    static final int SOME = 4;

    final Probe probe = new Probe();
    final WideProbe wide = new WideProbe();
    /** The tree that is to know the line, if it has wide nodes. */
    private @Nullable WideNodes nodes;
    /** The same if they are packed. */
    private @Nullable PackedNodes packed;
    int[] node = {};
    int[] near = {};
    /** Leaves to be asked, or nodes with such, and which of their children these are. */
    final int[] leaves = new int[SOME + WideNodes.MOST];
    final long[] which = new long[SOME + WideNodes.MOST];
    long visits;

    /** Called before the first box is asked about, and not at all if there is none: tells the line by {@link #along}. */
    protected abstract void aim(R ray);

    /**
     * Meets the items of a leaf, those at the places from {@code first} to {@code end} − 1.
     *
     * @return where the line ends now
     */
    protected abstract double meet(R ray, int first, int end);

    /** Asks the items of a leaf; true ends the search. */
    protected abstract boolean stopsAt(R ray, int first, int end);

    /** The number of tree nodes visited so far, leaves included. */
    public final long visits() {
        return visits;
    }

    /** Counts leaves that are met without a tree. */
    protected final void visit(int leaves) {
        visits += leaves;
    }

    /** Sets the line: its origin, its reciprocal direction, which must be finite, and between which t it counts. */
    protected final void along(double ox, double oy, double oz, double rx, double ry, double rz, double min, double max) {
        if (packed != null) {
            wide.set(packed, ox, oy, oz, rx, ry, rz, min, max);
        } else if (nodes == null) {
            probe.set(ox, oy, oz, rx, ry, rz, min, max);
        } else {
            wide.set(nodes, ox, oy, oz, rx, ry, rz, min, max);
        }
    }

    /** Tells a tree of wide nodes the line. */
    final WideProbe aimAt(WideNodes among, R ray) {
        if (nodes != among) {
            nodes = among;
            packed = null;
            wide.reserve(among.mostToVisit());
        }
        aim(ray);
        return wide;
    }

    /** Tells a packed tree the line. */
    final WideProbe aimAt(PackedNodes among, R ray) {
        if (packed != among) {
            packed = among;
            nodes = null;
            wide.reserve(among.mostToVisit());
        }
        aim(ray);
        return wide;
    }

    /** Tells a binary tree the line. */
    final void aimAtBoxes(R ray) {
        if (nodes != null) {
            nodes = null;
        }
        if (packed != null) {
            packed = null;
        }
        aim(ray);
    }

    /** Makes room for a tree. */
    final void reserve(int depth) {
        if (node.length < depth) {
            node = new int[depth];
            near = new int[depth];
        }
    }
}
