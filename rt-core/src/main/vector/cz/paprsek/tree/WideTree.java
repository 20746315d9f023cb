package cz.paprsek.tree;

import jdk.incubator.vector.ByteVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/** The tree for machines with vectors of eight floats: all children of a node are asked about at once. */
final class WideTree extends Tree {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    /** What holds a byte for each lane, and what the first eight of its bytes are read from as one number: of one long there are no vectors in Java 17. */
    private static final VectorSpecies<Byte> BYTES = ByteVector.SPECIES_64;
    private static final VectorSpecies<Long> LONGS = LongVector.SPECIES_128;
    private static final int WIDTH = WideNodes.WIDTH;
    private static final int STRIDE = WideNodes.STRIDE;
    /** Where in a node the names of the children begin. */
    private static final int NAMES = 6 * WIDTH;
    /** What is visited next if nothing is left; no leaf has that name. */
    private static final int NOTHING = 0;
    /** In place of a node: goes on with those to visit. */
    private static final int NEXT = -1;

    /** A one in each of eight bytes. */
    private static final long ALL = 0x0101_0101_0101_0101L;
    /** So many leaves are met by all lines of a frustum at once; where there are more, lines meet so few of their items that each line looks for its own. */
    private static final int ENOUGH = 48;

    private final WideNodes nodes;
    private final float[] data;

    WideTree(WideNodes nodes) {
        super(WideNodes.FIRST, nodes.depth);
        this.nodes = nodes;
        this.data = nodes.data;
        whole().point(data);
    }

    @Override
    public void enter(Bundle bundle, Entries entries) {
        entries.startWith(whole());
        nodes.open(bundle, entries);
        entries.gather(data);
    }

    @Override
    public void enter(Bundle bundle, Entries entries, Leaves taker) {
        Frustum frustum = bundle.frustum();
        // Of a leaf that is alone no box is known.
        if (depth < 2 || !frustum.aim(nodes, 3 * WIDTH)) {
            super.enter(bundle, entries, taker);
            entries.gather(data);
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
            int subtree = name(data, at, 0);
            if (subtree >= 0 && met < ENOUGH && entries.canHold(top + WIDTH)) {
                top = push(frustum, subtree, top);
            } else if (subtree < 0 && taker.take(first(subtree), end(subtree))) {
                met++;
            } else {
                entries.add(subtree, isQuick(subtree) ? Entries.ANYWHERE : at, Math.max(0, near));
            }
        }
        entries.gather(data);
    }

    /** Puts the children of a node that a frustum reaches into upon those to be visited, and returns how many there are then. */
    private int push(Frustum frustum, int node, int from) {
        float[] nodeData = data;
        float[] x = frustum.x;
        float[] y = frustum.y;
        float[] z = frustum.z;
        float[] w = frustum.w;
        int[] atX = frustum.atX;
        int[] atY = frustum.atY;
        int[] atZ = frustum.atZ;
        FloatVector a = FloatVector.fromArray(FLOATS, nodeData, node + atX[0]).mul(x[0]).add(FloatVector.fromArray(FLOATS, nodeData, node + atY[0]).mul(y[0]))
                .add(FloatVector.fromArray(FLOATS, nodeData, node + atZ[0]).mul(z[0])).add(w[0]);
        FloatVector b = FloatVector.fromArray(FLOATS, nodeData, node + atX[1]).mul(x[1]).add(FloatVector.fromArray(FLOATS, nodeData, node + atY[1]).mul(y[1]))
                .add(FloatVector.fromArray(FLOATS, nodeData, node + atZ[1]).mul(z[1])).add(w[1]);
        FloatVector c = FloatVector.fromArray(FLOATS, nodeData, node + atX[2]).mul(x[2]).add(FloatVector.fromArray(FLOATS, nodeData, node + atY[2]).mul(y[2]))
                .add(FloatVector.fromArray(FLOATS, nodeData, node + atZ[2]).mul(z[2])).add(w[2]);
        FloatVector d = FloatVector.fromArray(FLOATS, nodeData, node + atX[3]).mul(x[3]).add(FloatVector.fromArray(FLOATS, nodeData, node + atY[3]).mul(y[3]))
                .add(FloatVector.fromArray(FLOATS, nodeData, node + atZ[3]).mul(z[3])).add(w[3]);
        // Outside a plane is what lies below zero.
        long outside = a.reinterpretAsInts().lanewise(VectorOperators.OR, b.reinterpretAsInts())
                .lanewise(VectorOperators.OR, c.reinterpretAsInts().lanewise(VectorOperators.OR, d.reinterpretAsInts())).lanewise(VectorOperators.LSHR, 31)
                .convertShape(VectorOperators.I2B, BYTES, 0).reinterpretShape(LONGS, 0).reinterpretAsLongs().lane(0);
        int top = from;
        for (long hits = outside ^ ALL; hits != 0; hits &= hits - 1) {
            int at = node + (Long.numberOfTrailingZeros(hits) >>> 3);
            // The boxes of slots without a child are no number.
            if (name(nodeData, at, 0) == NOTHING) {
                break;
            }
            frustum.push(nodeData, at, from, top++);
        }
        return top;
    }

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
            int leaf = next(probe, search, entries.planes, WideNodes.FIRST + STRIDE * group);
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
            int found = leaves(probe, search, entries.planes, WideNodes.FIRST + STRIDE * group);
            while (found > 0) {
                for (int i = 0; i < found; i++) {
                    if (search.stopsAt(ray, first(search.leaves[i]), end(search.leaves[i]))) {
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
     * become objects. Of bytecodes there must be no more: C2 inlines up to 8000 of them, which vectors are made of mostly, and then leaves calls
     * in the middle, over which all vectors are put down and taken up again.
     *
     * @param from where the node to begin with is
     * @param first at which place, or {@link #NEXT} to go on with those that are left to visit
     */
    private int next(WideProbe probe, Search<?> search, float[] from, int first) {
        FloatVector lowX = FloatVector.broadcast(FLOATS, probe.lowX);
        FloatVector lowY = FloatVector.broadcast(FLOATS, probe.lowY);
        FloatVector lowZ = FloatVector.broadcast(FLOATS, probe.lowZ);
        FloatVector highX = FloatVector.broadcast(FLOATS, probe.highX);
        FloatVector highY = FloatVector.broadcast(FLOATS, probe.highY);
        FloatVector highZ = FloatVector.broadcast(FLOATS, probe.highZ);
        FloatVector rx = FloatVector.broadcast(FLOATS, probe.rx);
        FloatVector ry = FloatVector.broadcast(FLOATS, probe.ry);
        FloatVector rz = FloatVector.broadcast(FLOATS, probe.rz);
        IntVector begin = IntVector.broadcast(INTS, probe.begin);
        IntVector end = IntVector.broadcast(INTS, probe.end);
        long[] stack = probe.stack;
        int[] enters = probe.lanes;
        int farthest = probe.end + WideProbe.SLACK;
        float[] nodeData = from;
        int node = first;
        int top = probe.top;
        int visits = node == NEXT ? 0 : -1;
        while (true) {
            if (node == NEXT) {
                long entered;
                do {
                    if (top == 0) {
                        probe.top = 0;
                        search.visits += visits;
                        return NOTHING;
                    }
                    entered = stack[--top];
                } while ((int) (entered >> 32) > farthest);
                node = (int) entered;
                if (node < 0) {
                    probe.top = top;
                    search.visits += visits + 1;
                    return node;
                }
                nodeData = data;
            }
            visits++;
            // Which of the two the line crosses first is not asked of the ray, which would take six places to keep in mind: more than there are registers.
            IntVector lessX = FloatVector.fromArray(FLOATS, nodeData, node).sub(lowX).mul(rx).reinterpretAsInts();
            IntVector moreX = FloatVector.fromArray(FLOATS, nodeData, node + 3 * WIDTH).sub(highX).mul(rx).reinterpretAsInts();
            IntVector lessY = FloatVector.fromArray(FLOATS, nodeData, node + WIDTH).sub(lowY).mul(ry).reinterpretAsInts();
            IntVector moreY = FloatVector.fromArray(FLOATS, nodeData, node + 4 * WIDTH).sub(highY).mul(ry).reinterpretAsInts();
            IntVector lessZ = FloatVector.fromArray(FLOATS, nodeData, node + 2 * WIDTH).sub(lowZ).mul(rz).reinterpretAsInts();
            IntVector moreZ = FloatVector.fromArray(FLOATS, nodeData, node + 5 * WIDTH).sub(highZ).mul(rz).reinterpretAsInts();
            IntVector in = lessX.min(moreX).max(lessY.min(moreY)).max(lessZ.min(moreZ).max(begin));
            IntVector out = lessX.max(moreX).min(lessY.max(moreY)).min(lessZ.max(moreZ).min(end)).max(-1 - WideProbe.SLACK);
            // A byte for each lane, 1 where in ≤ out + slack: no mask, whose way to an integer Java 17 does not compile.
            long hits = in.sub(WideProbe.SLACK + 1).sub(out).lanewise(VectorOperators.LSHR, 31)
                    .convertShape(VectorOperators.I2B, BYTES, 0).reinterpretShape(LONGS, 0).reinterpretAsLongs().lane(0);
            // Mostly there is one, which need not go over the stack.
            if ((hits & hits - 1) == 0 && hits != 0) {
                node = Float.floatToRawIntBits(nodeData[node + NAMES + (Long.numberOfTrailingZeros(hits) >>> 3)]);
                if (node < 0) {
                    probe.top = top;
                    search.visits += visits + 1;
                    return node;
                }
                nodeData = data;
                continue;
            }
            if (hits != 0) {
                in.intoArray(enters, 0);
                int bottom = top;
                for (; hits != 0; hits &= hits - 1) {
                    int slot = Long.numberOfTrailingZeros(hits) >>> 3;
                    long entry = (long) enters[slot] << 32 | Float.floatToRawIntBits(nodeData[node + NAMES + slot]) & 0xFFFFFFFFL;
                    int place = top++;
                    for (; place > bottom && stack[place - 1] < entry; place--) {
                        stack[place] = stack[place - 1];
                    }
                    stack[place] = entry;
                }
            }
            node = NEXT;
        }
    }

    /**
     * Visits nodes until some leaves are found, in any order, and returns how many: they are named in {@link Search#leaves}. Several at once, since whoever asks
     * whether anything is met mostly has to ask them all.
     */
    private int leaves(WideProbe probe, Search<?> search, float[] from, int first) {
        int top = probe.top;
        if (first == NEXT && top == 0) {
            return 0;
        }
        FloatVector nearX = FloatVector.broadcast(FLOATS, probe.nearX);
        FloatVector nearY = FloatVector.broadcast(FLOATS, probe.nearY);
        FloatVector nearZ = FloatVector.broadcast(FLOATS, probe.nearZ);
        FloatVector farX = FloatVector.broadcast(FLOATS, probe.farX);
        FloatVector farY = FloatVector.broadcast(FLOATS, probe.farY);
        FloatVector farZ = FloatVector.broadcast(FLOATS, probe.farZ);
        FloatVector rx = FloatVector.broadcast(FLOATS, probe.rx);
        FloatVector ry = FloatVector.broadcast(FLOATS, probe.ry);
        FloatVector rz = FloatVector.broadcast(FLOATS, probe.rz);
        IntVector begin = IntVector.broadcast(INTS, probe.begin);
        IntVector end = IntVector.broadcast(INTS, probe.end);
        int firstX = probe.firstX;
        int firstY = probe.firstY;
        int firstZ = probe.firstZ;
        long[] stack = probe.stack;
        int[] leaves = search.leaves;
        float[] nodeData = from;
        int node = first;
        if (node == NEXT) {
            node = (int) stack[--top];
            nodeData = data;
        }
        int found = 0;
        int visits = first == NEXT ? 0 : -1;
        while (true) {
            visits++;
            IntVector in = FloatVector.fromArray(FLOATS, nodeData, node + firstX).sub(nearX).mul(rx).reinterpretAsInts()
                    .max(FloatVector.fromArray(FLOATS, nodeData, node + firstY).sub(nearY).mul(ry).reinterpretAsInts())
                    .max(FloatVector.fromArray(FLOATS, nodeData, node + firstZ).sub(nearZ).mul(rz).reinterpretAsInts().max(begin));
            IntVector out = FloatVector.fromArray(FLOATS, nodeData, node + 24 - firstX).sub(farX).mul(rx).reinterpretAsInts()
                    .min(FloatVector.fromArray(FLOATS, nodeData, node + 40 - firstY).sub(farY).mul(ry).reinterpretAsInts())
                    .min(FloatVector.fromArray(FLOATS, nodeData, node + 56 - firstZ).sub(farZ).mul(rz).reinterpretAsInts().min(end))
                    .max(-1 - WideProbe.SLACK);
            // A byte for each lane, 1 where in ≤ out + slack: fewer steps than to put bits together, each of which waits for the one before.
            long hits = in.sub(WideProbe.SLACK + 1).sub(out).lanewise(VectorOperators.LSHR, 31)
                    .convertShape(VectorOperators.I2B, BYTES, 0).reinterpretShape(LONGS, 0).reinterpretAsLongs().lane(0);
            if (hits != 0) {
                int next = name(nodeData, node, Long.numberOfTrailingZeros(hits) >>> 3);
                for (long others = hits & hits - 1; others != 0; others &= others - 1) {
                    int name = name(nodeData, node, Long.numberOfTrailingZeros(others) >>> 3);
                    // Both are written, and one stays: no branch, which could not be foretold.
                    leaves[found] = name;
                    stack[top] = name;
                    found += name >>> 31;
                    top += ~name >>> 31;
                }
                // Mostly there is one, which need not go over the stack.
                if (next >= 0 && found < Search.SOME) {
                    node = next;
                    nodeData = data;
                    continue;
                }
                leaves[found] = next;
                stack[top] = next;
                found += next >>> 31;
                top += ~next >>> 31;
            }
            if (top == 0 || found >= Search.SOME) {
                probe.top = top;
                search.visits += visits + found;
                return found;
            }
            node = (int) stack[--top];
            nodeData = data;
        }
    }

    private static int name(float[] data, int node, int slot) {
        return Float.floatToRawIntBits(data[node + NAMES + slot]);
    }
}
