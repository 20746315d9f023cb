package cz.paprsek.render;

/** Scratch of one worker: the subtrees of a hierarchy in which a search starts, the nearest first. */
final class Entries {
    /** The most subtrees that are worth keeping apart. */
    static final int MOST = 8;
    /** In place of a box: the subtree is searched without asking. */
    static final int ANYWHERE = -1;

    final int[] node = new int[MOST + 1];
    /** Where the box of each subtree starts in the hierarchy's array. */
    final int[] box = new int[MOST + 1];
    private final double[] near = new double[MOST + 1];
    int size;
    private int leaves;

    void clear() {
        size = 0;
        leaves = 0;
    }

    /** Whether no entry has anything below it to search. */
    boolean areLeaves() {
        return leaves == size;
    }

    void add(int subtree, int itsBox, double enter) {
        leaves += subtree < 0 ? 1 : 0;
        int at = size++;
        for (; at > 0 && near[at - 1] > enter; at--) {
            copy(at - 1, at);
        }
        node[at] = subtree;
        box[at] = itsBox;
        near[at] = enter;
    }

    void remove(int at) {
        leaves -= node[at] < 0 ? 1 : 0;
        size--;
        for (int i = at; i < size; i++) {
            copy(i + 1, i);
        }
    }

    private void copy(int from, int to) {
        node[to] = node[from];
        box[to] = box[from];
        near[to] = near[from];
    }
}
