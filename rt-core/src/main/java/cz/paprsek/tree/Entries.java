package cz.paprsek.tree;

/** Scratch of one worker: the subtrees of a tree in which a search starts, the nearest first. */
public final class Entries {
    /** In place of a box: the subtree is searched without asking. */
    static final int ANYWHERE = -1;

    final int[] node;
    /** Where the box of each subtree starts in the tree's array. */
    final int[] box;
    /** Up to which t no line meets anything in the subtree. */
    final double[] near;
    int size;
    private int boxes;

    /** @param most how many subtrees are kept apart at most */
    public Entries(int most) {
        // One more: a subtree that is opened gives way only after its halves have been added.
        node = new int[most + 1];
        box = new int[most + 1];
        near = new double[most + 1];
    }

    boolean isFull() {
        return size == node.length - 1;
    }

    /** Whether a search of these subtrees can find nothing at all. */
    public boolean isEmpty() {
        return size == 0;
    }

    void startWith(Entries others) {
        size = 0;
        boxes = 0;
        for (int i = 0; i < others.size; i++) {
            add(others.node[i], others.box[i], others.near[i]);
        }
    }

    /** Whether there is anything else than leaves that are searched without asking. */
    boolean haveBoxes() {
        return boxes > 0;
    }

    void add(int subtree, int itsBox, double enter) {
        boxes += itsBox == ANYWHERE && subtree < 0 ? 0 : 1;
        int at = size++;
        for (; at > 0 && near[at - 1] > enter; at--) {
            copy(at - 1, at);
        }
        node[at] = subtree;
        box[at] = itsBox;
        near[at] = enter;
    }

    void remove(int at) {
        boxes -= box[at] == ANYWHERE && node[at] < 0 ? 0 : 1;
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
