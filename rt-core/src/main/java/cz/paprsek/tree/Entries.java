package cz.paprsek.tree;

/** Scratch of one worker: the subtrees of a tree in which a search starts, the nearest first. */
public final class Entries {
    /** In place of a box: the subtree is searched without asking. */
    static final int ANYWHERE = -1;
    /** So many of the children of a node count at most when it is to be opened: of sixteen the lines of a bundle mostly pass by the others. */
    private static final int COUNTED = 8;

    private final int most;
    final int[] node;
    /** Where the box of each subtree starts in the tree's array. */
    final int[] box;
    /** Up to which t no line meets anything in the subtree. */
    final double[] near;
    int size;
    private int boxes;

    /** For a tree of {@linkplain WideNodes wide nodes}: all but leaves that are searched without asking, as if children of a few nodes. */
    float[] planes = {};
    int groups;
    /** Up to which t no line meets anything in a group. */
    final double[] groupNear;

    /**
     * @param most how many subtrees are kept apart at most, some more where nodes have more than {@value #COUNTED} children; unless they are looked for by a frustum: then twice as many
     */
    public Entries(int most) {
        // One more: a subtree that is opened gives way only after its halves have been added. And as many again for who opens only what is worth it, and for children that do not count.
        this.most = most + 1;
        int room = 2 * this.most;
        node = new int[room];
        box = new int[room];
        near = new double[room];
        groupNear = new double[room];
    }

    /**
     * One leaf of the first items of any tree, searched without asking for a box.
     *
     * @param count how many they are, at most {@value Tree#LEAF}
     */
    public static Entries atOnce(int count) {
        Entries all = new Entries(1);
        all.add(Tree.leaf(0, count, 0), ANYWHERE, 0);
        return all;
    }

    boolean isFull() {
        return !haveRoomFor(2);
    }

    /** Whether a subtree could be opened that has so many children. */
    boolean haveRoomFor(int children) {
        return size + Math.min(children, COUNTED) <= most;
    }

    /** Whether so many could be added at all. */
    boolean canHold(int more) {
        return size + more <= node.length;
    }

    /** Whether a search of these subtrees can find nothing at all. */
    public boolean isEmpty() {
        return size == 0;
    }

    void clear() {
        size = 0;
        boxes = 0;
    }

    /** Offers the leaves, the nearest first; those that are taken need not be searched any more. */
    void offer(Leaves taker) {
        int kept = 0;
        int all = size;
        clear();
        for (int i = 0; i < all; i++) {
            boolean isBehind = node[i] < 0 && near[i] >= taker.reach();
            if (!isBehind && !(node[i] < 0 && taker.take(Tree.first(node[i]), Tree.end(node[i])))) {
                boxes += isLeafAnywhere(i) ? 0 : 1;
                copy(i, kept++);
            }
        }
        size = kept;
    }

    void startWith(Entries others) {
        clear();
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

    /** Whether this is a leaf that is searched without asking. */
    boolean isLeafAnywhere(int at) {
        return box[at] == ANYWHERE && node[at] < 0;
    }

    /** Makes one group of a node. */
    void point(float[] itsPlanes) {
        planes = itsPlanes;
        groups = size;
    }

    /** Puts the boxes side by side, as if in nodes of so many children. */
    void gather(float[] from, int width) {
        int stride = WideNodes.EACH * width;
        if (planes.length == 0) {
            planes = new float[WideNodes.FIRST + WideNodes.EACH * (node.length + WideNodes.MOST)];
        }
        int count = 0;
        for (int i = 0; i < size; i++) {
            if (box[i] != ANYWHERE) {
                int group = count / width;
                int slot = count % width;
                if (slot == 0) {
                    groupNear[group] = near[i];
                }
                int to = WideNodes.FIRST + stride * group;
                int lane = WideNodes.lane(width, slot);
                for (int k = 0; k < 6; k++) {
                    planes[to + width * k + lane] = from[box[i] + width * k];
                }
                planes[to + width * 6 + slot] = Float.intBitsToFloat(node[i]);
                count++;
            }
        }
        groups = (count + width - 1) / width;
        for (; count % width != 0; count++) {
            int at = WideNodes.FIRST + stride * (groups - 1) + WideNodes.lane(width, count % width);
            for (int k = 0; k < 6; k++) {
                planes[at + width * k] = Float.NaN;
            }
        }
    }

    private void copy(int from, int to) {
        node[to] = node[from];
        box[to] = box[from];
        near[to] = near[from];
    }
}
