package cz.paprsek.tree;

import static cz.paprsek.tree.WideProbe.bits;

/**
 * A large tree for any machine: four children a node, in floats. All four are asked about without a branch: whether a box is met cannot be foretold, and a wrong
 * guess takes as long as a box.
 */
final class FourTree extends Tree {
    /** So many nodes of the binary tree make it worth while. */
    static final int MANY = 1 << 10;
    static final int WIDTH = 4;
    /** Where in a node the names of the children begin. */
    private static final int NAMES = 6 * WIDTH;
    /** What is visited next if nothing is left; no leaf has that name. */
    private static final int NOTHING = 0;

    private final WideNodes nodes;
    private final float[] data;

    FourTree(WideNodes nodes) {
        super(WideNodes.FIRST, nodes.depth);
        this.nodes = nodes;
        this.data = nodes.data;
    }

    @Override
    public void enter(Bundle bundle, Entries entries) {
        entries.startWith(whole());
        nodes.open(bundle, entries);
    }

    @Override
    public <R> void nearest(Search<R> search, R ray, Entries entries, double end) {
        WideProbe probe = search.wide;
        if (entries.haveBoxes()) {
            search.aimAt(nodes, ray);
        }
        double reach = end;
        for (int i = 0; i < entries.size && entries.near[i] < reach; i++) {
            if (entries.box[i] == Entries.ANYWHERE || probe.enters(data, entries.box[i])) {
                int leaf = entries.node[i];
                if (leaf >= 0) {
                    probe.stack[0] = leaf;
                    probe.top = 1;
                    leaf = next(probe, search);
                } else {
                    probe.top = 0;
                    search.visits++;
                }
                while (leaf != NOTHING) {
                    reach = search.meet(ray, first(leaf), end(leaf));
                    probe.end(reach);
                    leaf = next(probe, search);
                }
            }
        }
    }

    @Override
    public <R> boolean any(Search<R> search, R ray, Entries entries) {
        WideProbe probe = search.wide;
        search.reserve(nodes.mostToVisit());
        if (entries.haveBoxes()) {
            search.aimAt(nodes, ray);
        }
        for (int i = 0; i < entries.size; i++) {
            if (entries.box[i] == Entries.ANYWHERE || probe.enters(data, entries.box[i])) {
                int node = entries.node[i];
                if (node < 0) {
                    search.visits++;
                    if (search.stopsAt(ray, first(node), end(node))) {
                        return true;
                    }
                } else if (any(search, ray, node)) {
                    return true;
                }
            }
        }
        return false;
    }

    private <R> boolean any(Search<R> search, R ray, int node) {
        WideProbe probe = search.wide;
        search.node[0] = node;
        probe.top = 1;
        while (probe.top > 0) {
            int found = leaves(probe, search);
            for (int i = 0; i < found; i++) {
                int leaf = search.leaves[i];
                if (search.stopsAt(ray, first(leaf), end(leaf))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Visits nodes up to the next leaf, and returns its name, or {@link #NOTHING}. */
    private int next(WideProbe probe, Search<?> search) {
        long[] stack = probe.stack;
        float nearX = probe.nearX;
        float nearY = probe.nearY;
        float nearZ = probe.nearZ;
        float farX = probe.farX;
        float farY = probe.farY;
        float farZ = probe.farZ;
        float rx = probe.rx;
        float ry = probe.ry;
        float rz = probe.rz;
        int begin = probe.begin;
        int end = probe.end;
        // The probe counts in nodes of eight.
        int inX = probe.firstX / 2;
        int inY = probe.firstY / 2;
        int inZ = probe.firstZ / 2;
        int outX = 12 - inX;
        int outY = 20 - inY;
        int outZ = 28 - inZ;
        int top = probe.top;
        int farthest = end + WideProbe.SLACK;
        int visits = 0;
        while (top > 0) {
            long entered = stack[--top];
            if ((int) (entered >> 32) > farthest) {
                continue;
            }
            visits++;
            int node = (int) entered;
            if (node < 0) {
                probe.top = top;
                search.visits += visits;
                return node;
            }
            int in0 = Math.max(
                    Math.max(bits((data[node + inX] - nearX) * rx), bits((data[node + inY] - nearY) * ry)),
                    Math.max(bits((data[node + inZ] - nearZ) * rz), begin));
            int in1 = Math.max(
                    Math.max(bits((data[node + inX + 1] - nearX) * rx), bits((data[node + inY + 1] - nearY) * ry)),
                    Math.max(bits((data[node + inZ + 1] - nearZ) * rz), begin));
            int in2 = Math.max(
                    Math.max(bits((data[node + inX + 2] - nearX) * rx), bits((data[node + inY + 2] - nearY) * ry)),
                    Math.max(bits((data[node + inZ + 2] - nearZ) * rz), begin));
            int in3 = Math.max(
                    Math.max(bits((data[node + inX + 3] - nearX) * rx), bits((data[node + inY + 3] - nearY) * ry)),
                    Math.max(bits((data[node + inZ + 3] - nearZ) * rz), begin));
            int out0 = Math.min(
                    Math.min(bits((data[node + outX] - farX) * rx), bits((data[node + outY] - farY) * ry)),
                    Math.min(bits((data[node + outZ] - farZ) * rz), end));
            int out1 = Math.min(
                    Math.min(bits((data[node + outX + 1] - farX) * rx), bits((data[node + outY + 1] - farY) * ry)),
                    Math.min(bits((data[node + outZ + 1] - farZ) * rz), end));
            int out2 = Math.min(
                    Math.min(bits((data[node + outX + 2] - farX) * rx), bits((data[node + outY + 2] - farY) * ry)),
                    Math.min(bits((data[node + outZ + 2] - farZ) * rz), end));
            int out3 = Math.min(
                    Math.min(bits((data[node + outX + 3] - farX) * rx), bits((data[node + outY + 3] - farY) * ry)),
                    Math.min(bits((data[node + outZ + 3] - farZ) * rz), end));
            // Below zero where in ≤ out + slack, and out is not behind the beginning.
            int hit0 = in0 - out0 - (WideProbe.SLACK + 1) & ~out0;
            int hit1 = in1 - out1 - (WideProbe.SLACK + 1) & ~out1;
            int hit2 = in2 - out2 - (WideProbe.SLACK + 1) & ~out2;
            int hit3 = in3 - out3 - (WideProbe.SLACK + 1) & ~out3;
            int bottom = top;
            stack[top] = entry(in0, bits(data[node + NAMES]));
            top += hit0 >>> 31;
            stack[top] = entry(in1, bits(data[node + NAMES + 1]));
            top += hit1 >>> 31;
            stack[top] = entry(in2, bits(data[node + NAMES + 2]));
            top += hit2 >>> 31;
            stack[top] = entry(in3, bits(data[node + NAMES + 3]));
            top += hit3 >>> 31;
            // The nearest on top.
            for (int i = bottom + 1; i < top; i++) {
                long entry = stack[i];
                int place = i;
                for (; place > bottom && stack[place - 1] < entry; place--) {
                    stack[place] = stack[place - 1];
                }
                stack[place] = entry;
            }
        }
        probe.top = 0;
        search.visits += visits;
        return NOTHING;
    }

    private static long entry(int near, int name) {
        return (long) near << 32 | (name & 0xFFFFFFFFL);
    }

    /** Visits nodes until some leaves are found, in any order, and returns how many: they are named in {@link Search#leaves}. */
    private int leaves(WideProbe probe, Search<?> search) {
        int[] stack = search.node;
        int[] leaves = search.leaves;
        float nearX = probe.nearX;
        float nearY = probe.nearY;
        float nearZ = probe.nearZ;
        float farX = probe.farX;
        float farY = probe.farY;
        float farZ = probe.farZ;
        float rx = probe.rx;
        float ry = probe.ry;
        float rz = probe.rz;
        int begin = probe.begin;
        int end = probe.end;
        // The probe counts in nodes of eight.
        int inX = probe.firstX / 2;
        int inY = probe.firstY / 2;
        int inZ = probe.firstZ / 2;
        int outX = 12 - inX;
        int outY = 20 - inY;
        int outZ = 28 - inZ;
        int top = probe.top;
        int found = 0;
        int visits = 0;
        while (top > 0 && found < Search.SOME) {
            visits++;
            int node = stack[--top];
            int in0 = Math.max(
                    Math.max(bits((data[node + inX] - nearX) * rx), bits((data[node + inY] - nearY) * ry)),
                    Math.max(bits((data[node + inZ] - nearZ) * rz), begin));
            int in1 = Math.max(
                    Math.max(bits((data[node + inX + 1] - nearX) * rx), bits((data[node + inY + 1] - nearY) * ry)),
                    Math.max(bits((data[node + inZ + 1] - nearZ) * rz), begin));
            int in2 = Math.max(
                    Math.max(bits((data[node + inX + 2] - nearX) * rx), bits((data[node + inY + 2] - nearY) * ry)),
                    Math.max(bits((data[node + inZ + 2] - nearZ) * rz), begin));
            int in3 = Math.max(
                    Math.max(bits((data[node + inX + 3] - nearX) * rx), bits((data[node + inY + 3] - nearY) * ry)),
                    Math.max(bits((data[node + inZ + 3] - nearZ) * rz), begin));
            int out0 = Math.min(
                    Math.min(bits((data[node + outX] - farX) * rx), bits((data[node + outY] - farY) * ry)),
                    Math.min(bits((data[node + outZ] - farZ) * rz), end));
            int out1 = Math.min(
                    Math.min(bits((data[node + outX + 1] - farX) * rx), bits((data[node + outY + 1] - farY) * ry)),
                    Math.min(bits((data[node + outZ + 1] - farZ) * rz), end));
            int out2 = Math.min(
                    Math.min(bits((data[node + outX + 2] - farX) * rx), bits((data[node + outY + 2] - farY) * ry)),
                    Math.min(bits((data[node + outZ + 2] - farZ) * rz), end));
            int out3 = Math.min(
                    Math.min(bits((data[node + outX + 3] - farX) * rx), bits((data[node + outY + 3] - farY) * ry)),
                    Math.min(bits((data[node + outZ + 3] - farZ) * rz), end));
            // Below zero where in ≤ out + slack, and out is not behind the beginning.
            int hit0 = in0 - out0 - (WideProbe.SLACK + 1) & ~out0;
            int hit1 = in1 - out1 - (WideProbe.SLACK + 1) & ~out1;
            int hit2 = in2 - out2 - (WideProbe.SLACK + 1) & ~out2;
            int hit3 = in3 - out3 - (WideProbe.SLACK + 1) & ~out3;
            int name0 = bits(data[node + NAMES]);
            int name1 = bits(data[node + NAMES + 1]);
            int name2 = bits(data[node + NAMES + 2]);
            int name3 = bits(data[node + NAMES + 3]);
            // All are written, and those stay that are met: leaves, whose names are negative, here and nodes there.
            leaves[found] = name0;
            found += (name0 & hit0) >>> 31;
            leaves[found] = name1;
            found += (name1 & hit1) >>> 31;
            leaves[found] = name2;
            found += (name2 & hit2) >>> 31;
            leaves[found] = name3;
            found += (name3 & hit3) >>> 31;
            stack[top] = name0;
            top += (~name0 & hit0) >>> 31;
            stack[top] = name1;
            top += (~name1 & hit1) >>> 31;
            stack[top] = name2;
            top += (~name2 & hit2) >>> 31;
            stack[top] = name3;
            top += (~name3 & hit3) >>> 31;
        }
        probe.top = top;
        search.visits += visits + found;
        return found;
    }
}
