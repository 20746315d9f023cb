package cz.paprsek.tree;

import java.util.Arrays;

/**
 * The tree for any machine: an inner node n has two children. {@code child[2n]} and {@code child[2n + 1]} name them: an inner node if not
 * negative, else a leaf. {@code boxes[12n…]} holds the boxes of both, each as minimum x y z, maximum x y z.
 */
final class BinaryTree extends Tree {
    /** So many leaves are met by all lines of a frustum at once at most. */
    private static final int ENOUGH = 48;

    private final double[] boxes;
    private final int[] child;
    /** No number of a box is larger. */
    private final double largest;

    BinaryTree(BinaryNodes nodes) {
        super(nodes.root, nodes.depth);
        this.boxes = nodes.boxes;
        this.child = nodes.child;
        this.largest = Arrays.stream(boxes).map(Math::abs).max().orElse(0);
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
    public void enter(Bundle bundle, Entries entries, Leaves taker) {
        Frustum frustum = bundle.frustum();
        // Of a leaf that is alone no box is known.
        if (depth < 2) {
            super.enter(bundle, entries, taker);
            return;
        }
        frustum.aim(largest, depth + 1);
        entries.clear();
        int met = 0;
        int top = push(frustum, 0, 0);
        while (top > 0) {
            int at = frustum.box[--top];
            double near = frustum.near[top];
            if (near >= taker.reach()) {
                continue;
            }
            int subtree = child[at / 6];
            if (subtree >= 0 && met < ENOUGH && entries.canHold(top + 2)) {
                top = push(frustum, subtree, top);
            } else if (subtree < 0 && taker.take(first(subtree), end(subtree))) {
                met++;
            } else {
                entries.add(subtree, isQuick(subtree) ? Entries.ANYWHERE : at, Math.max(0, near));
            }
        }
    }

    /** Puts the children of a node that a frustum reaches into upon those to be visited, the nearer on top, and returns how many there are then. */
    private int push(Frustum frustum, int node, int from) {
        int left = 12 * node;
        int right = left + 6;
        boolean isLeft = frustum.meets(boxes, left);
        boolean isRight = frustum.meets(boxes, right);
        int top = from;
        if (isLeft && isRight) {
            double toLeft = frustum.distance(boxes, left);
            double toRight = frustum.distance(boxes, right);
            boolean isLeftFirst = toLeft <= toRight;
            frustum.box[top] = isLeftFirst ? right : left;
            frustum.near[top++] = isLeftFirst ? toRight : toLeft;
            frustum.box[top] = isLeftFirst ? left : right;
            frustum.near[top++] = isLeftFirst ? toLeft : toRight;
        } else if (isLeft || isRight) {
            int box = isLeft ? left : right;
            frustum.box[top] = box;
            frustum.near[top++] = frustum.distance(boxes, box);
        }
        return top;
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
