package cz.paprsek.tree;

/** A tree for machines with vectors: all children of a node are asked about at once. A virtual machine has one kind, so that what is called here is foreseen. */
abstract class WideTree extends Tree {
    /** What is visited next if nothing is left; no leaf has that name. */
    static final int NOTHING = 0;
    /** In place of a node: goes on with those to visit. */
    static final int NEXT = -1;

    /** So many leaves are met by all lines of a frustum at once; where there are more, lines meet so few of their items that each line looks for its own. */
    private static final int ENOUGH = 48;

    private final WideNodes nodes;
    private final int stride;
    final float[] data;

    WideTree(WideNodes nodes) {
        super(WideNodes.FIRST, nodes.depth);
        this.nodes = nodes;
        this.stride = nodes.stride;
        this.data = nodes.data;
        whole().point(data);
    }

    @Override
    public void enter(Bundle bundle, Entries entries) {
        entries.startWith(whole());
        nodes.open(bundle, entries);
        entries.gather(data, nodes.width);
    }

    @Override
    public void enter(Bundle bundle, Entries entries, Leaves taker) {
        Frustum frustum = bundle.frustum();
        // Of a leaf that is alone no box is known.
        if (depth < 2 || !frustum.aim(nodes, 3 * nodes.width)) {
            super.enter(bundle, entries, taker);
            entries.gather(data, nodes.width);
            return;
        }
        entries.clear();
        int met = 0;
        int top = push(frustum, WideNodes.FIRST, 0);
        while (top > 0) {
            int at = frustum.box[--top];
            double near = frustum.near[top];
            if (near >= taker.reach()) {
                continue;
            }
            int subtree = name(at);
            if (subtree >= 0 && met < ENOUGH && entries.canHold(top + nodes.width)) {
                top = push(frustum, subtree, top);
            } else if (subtree < 0 && taker.take(first(subtree), end(subtree))) {
                met++;
            } else {
                entries.add(subtree, isQuick(subtree) ? Entries.ANYWHERE : at, Math.max(0, near));
            }
        }
        entries.gather(data, nodes.width);
    }

    /** Puts the children of a node that a frustum reaches into upon those to be visited, and returns how many there are then. */
    abstract int push(Frustum frustum, int node, int from);

    /** What is in the box that begins at {@code at}. */
    abstract int name(int at);

    @Override
    public <R> void nearest(Search<R> search, R ray, Entries entries, double end) {
        double reach = end;
        for (int i = 0; i < entries.size && entries.near[i] < reach; i++) {
            if (entries.isLeafAnywhere(i)) {
                search.visits++;
                reach = search.meet(ray, first(entries.node[i]), end(entries.node[i]));
            }
        }
        if (entries.groups == 0) {
            return;
        }
        WideProbe probe = search.aimAt(nodes, ray);
        for (int group = 0; group < entries.groups && entries.groupNear[group] < reach; group++) {
            int leaf = next(probe, search, entries.planes, WideNodes.FIRST + stride * group);
            while (leaf != NOTHING) {
                reach = search.meet(ray, first(leaf), end(leaf));
                probe.end(reach);
                leaf = next(probe, search, data, NEXT);
            }
        }
    }

    @Override
    public <R> boolean any(Search<R> search, R ray, Entries entries) {
        for (int i = 0; i < entries.size; i++) {
            if (entries.isLeafAnywhere(i)) {
                search.visits++;
                if (search.stopsAt(ray, first(entries.node[i]), end(entries.node[i]))) {
                    return true;
                }
            }
        }
        if (entries.groups == 0) {
            return false;
        }
        WideProbe probe = search.aimAt(nodes, ray);
        for (int group = 0; group < entries.groups; group++) {
            int found = leaves(probe, search, entries.planes, WideNodes.FIRST + stride * group);
            while (found > 0) {
                for (int i = 0; i < found; i++) {
                    if (stopsAt(search, ray, i)) {
                        return true;
                    }
                }
                found = leaves(probe, search, data, NEXT);
            }
        }
        return false;
    }

    /**
     * Visits nodes up to the next leaf, and returns its name, or {@link #NOTHING}. Vectors live in this method only: handed on, they would
     * become objects. Of bytecodes there must be few: C2 inlines up to 8000 of them, which vectors are made of mostly, and then leaves calls
     * in the middle, over which all vectors are put down and taken up again.
     *
     * @param from where the node to begin with is
     * @param first at which place, or {@link #NEXT} to go on with those that are left to visit
     */
    abstract int next(WideProbe probe, Search<?> search, float[] from, int first);

    /**
     * Visits nodes until some leaves are found, in any order, and returns in how many places: they are named in {@link Search#leaves}. Several at once, since whoever asks
     * whether anything is met mostly has to ask them all.
     */
    abstract int leaves(WideProbe probe, Search<?> search, float[] from, int first);

    /** Asks what was found in one place; true ends the search. */
    abstract <R> boolean stopsAt(Search<R> search, R ray, int place);
}
