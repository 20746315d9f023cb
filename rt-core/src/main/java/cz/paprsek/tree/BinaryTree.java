package cz.paprsek.tree;

/**
 * The tree for any machine: an inner node n has two children. {@code child[2n]} and {@code child[2n + 1]} name them: an inner node if not
 * negative, else a leaf. {@code boxes[12n…]} holds the boxes of both, each as minimum x y z, maximum x y z.
 */
final class BinaryTree extends Tree {
    private final double[] boxes;
    private final int[] child;

    BinaryTree(BinaryNodes nodes) {
        super(nodes.root, nodes.depth);
        this.boxes = nodes.boxes;
        this.child = nodes.child;
    }

    /** The nearest inner node is opened again and again until all are leaves, or there would be too many. */
    @Override
    public void enter(Bundle bundle, Entries entries) {
        double unit = bundle.shortest();
        entries.startWith(whole());
        int i = 0;
        while (i < entries.size) {
            int node = entries.node[i];
            if (node < 0 || entries.isFull()) {
                i++;
                continue;
            }
            entries.remove(i);
            for (int side = 0; side < 2; side++) {
                double near = bundle.enter(boxes, 12 * node + 6 * side);
                if (near < Double.POSITIVE_INFINITY) {
                    int subtree = child[2 * node + side];
                    entries.add(subtree, isQuick(subtree) ? Entries.ANYWHERE : 12 * node + 6 * side, near * unit);
                }
            }
        }
    }

    @Override
    public <R> void nearest(Search<R> search, R ray, Entries entries, double end) {
        Probe probe = search.probe;
        search.reserve(depth);
        if (entries.haveBoxes()) {
            search.aimAtBoxes(ray);
        }
        double reach = end;
        for (int i = 0; i < entries.size && entries.near[i] < reach; i++) {
            if (entries.box[i] == Entries.ANYWHERE || probe.enter(boxes, entries.box[i]) != Probe.MISS) {
                reach = nearest(search, ray, entries.node[i], reach);
            }
        }
    }

    private <R> double nearest(Search<R> search, R ray, int subtree, double end) {
        if (subtree < 0) {
            return meetLeaf(search, ray, subtree);
        }
        Probe probe = search.probe;
        double reach = end;
        int top = 0;
        int node = subtree;
        while (true) {
            while (node >= 0) {
                search.visits++;
                int left = probe.enter(boxes, 12 * node);
                int right = probe.enter(boxes, 12 * node + 6);
                int first = left <= right ? 2 * node : 2 * node + 1;
                if (left != Probe.MISS && right != Probe.MISS) {
                    search.node[top] = child[first ^ 1];
                    search.near[top++] = Math.max(left, right);
                } else if (left == right) {
                    break;
                }
                node = child[first];
            }
            if (node < 0) {
                reach = meetLeaf(search, ray, node);
            }
            do {
                if (top == 0) {
                    return reach;
                }
                node = search.node[--top];
            } while (!probe.reaches(search.near[top]));
        }
    }

    private static <R> double meetLeaf(Search<R> search, R ray, int leaf) {
        search.visits++;
        double reach = search.meet(ray, first(leaf), end(leaf));
        search.probe.end(reach);
        return reach;
    }

    @Override
    public <R> boolean any(Search<R> search, R ray, Entries entries) {
        Probe probe = search.probe;
        search.reserve(depth);
        if (entries.haveBoxes()) {
            search.aimAtBoxes(ray);
        }
        for (int i = 0; i < entries.size; i++) {
            if ((entries.box[i] == Entries.ANYWHERE || probe.enter(boxes, entries.box[i]) != Probe.MISS) && any(search, ray, entries.node[i])) {
                return true;
            }
        }
        return false;
    }

    private <R> boolean any(Search<R> search, R ray, int subtree) {
        if (subtree < 0) {
            return askLeaf(search, ray, subtree);
        }
        Probe probe = search.probe;
        int top = 0;
        int node = subtree;
        while (true) {
            while (node >= 0) {
                search.visits++;
                boolean left = probe.enter(boxes, 12 * node) != Probe.MISS;
                boolean right = probe.enter(boxes, 12 * node + 6) != Probe.MISS;
                if (left && right) {
                    search.node[top++] = child[2 * node + 1];
                } else if (!left && !right) {
                    break;
                }
                node = child[left ? 2 * node : 2 * node + 1];
            }
            if (node < 0 && askLeaf(search, ray, node)) {
                return true;
            }
            if (top == 0) {
                return false;
            }
            node = search.node[--top];
        }
    }

    private static <R> boolean askLeaf(Search<R> search, R ray, int leaf) {
        search.visits++;
        return search.stopsAt(ray, first(leaf), end(leaf));
    }
}
