package cz.paprsek.tree;

import cz.paprsek.math.Bounds;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * A hierarchy of boxes over items, which stand in the order of its leaves: a leaf is a run of at most {@value #LEAF} neighbours.
 * Immutable; any number of workers may search it at once, each with a {@link Search} of its own.
 */
public abstract class Tree {
    /** The most items in one leaf. */
    public static final int LEAF = 8;
    /** The cost up to which all items of a leaf are met rather than first its box asked. */
    private static final double QUICK = 4;

    /** How many nodes lie from the root to the farthest leaf, both counted; 0 if there is nothing in the tree. */
    final int depth;
    private final Entries whole = new Entries(1);

    Tree(int root, int depth) {
        this.depth = depth;
        if (depth > 0) {
            whole.add(root, Entries.ANYWHERE, 0);
        }
    }

    /** Where a search starts that knows nothing of its line. */
    public final Entries whole() {
        return whole;
    }

    /** Finds the subtrees that hold whatever the lines of a bundle can meet. */
    public abstract void enter(Bundle bundle, Entries entries);

    /**
     * The same, but for leaves that are met at once, the nearest first as far as boxes tell.
     *
     * @param bundle has a {@linkplain Bundle#hasFrustum frustum}
     */
    public void enter(Bundle bundle, Entries entries, Leaves taker) {
        enter(bundle, entries);
        entries.offer(taker);
    }

    /**
     * Meets the leaves in the given subtrees whose boxes the line enters before its end, the nearest first as far as boxes tell.
     *
     * @param end where the line ends; each leaf that is met may lower it
     */
    public abstract <R> void nearest(Search<R> search, R ray, Entries entries, double end);

    /** Asks the leaves in the given subtrees whose boxes the line meets, in any order, until one {@linkplain Search#stopsAt ends the search}. */
    public abstract <R> boolean any(Search<R> search, R ray, Entries entries);

    /**
     * Whether some item is taken, of those in leaves whose boxes reach into another box, and perhaps of others near them. If very many do, the answer may be
     * that one is without asking each.
     */
    public final boolean any(Bounds box, IntPredicate isTaken) {
        Bundle still = new Bundle();
        still.start(box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ());
        still.add(0, 0, 0);
        still.end(1);
        Entries entries = new Entries(256);
        enter(still, entries);
        for (int i = 0; i < entries.size; i++) {
            if (entries.node[i] >= 0 || IntStream.range(first(entries.node[i]), end(entries.node[i])).anyMatch(isTaken)) {
                return true;
            }
        }
        return false;
    }

    /** The name of a leaf: the complement of its first place, its count − 1 and whether it is {@linkplain #isQuick quick}, bit by bit. */
    static int leaf(int first, int count, double cost) {
        return ~(first * (2 * LEAF) + 2 * (count - 1) + (cost <= QUICK ? 1 : 0));
    }

    /** The name of a leaf with the same count at places that are so many farther. */
    static int moved(int leaf, int by) {
        return leaf - by * (2 * LEAF);
    }

    static int first(int leaf) {
        return ~leaf / (2 * LEAF);
    }

    static int end(int leaf) {
        return first(leaf) + ~leaf / 2 % LEAF + 1;
    }

    /** Whether a subtree is a leaf that takes less time than a test of its box for every line would, if the line is likely to meet it. */
    static boolean isQuick(int subtree) {
        return subtree < 0 && (~subtree & 1) != 0;
    }
}
