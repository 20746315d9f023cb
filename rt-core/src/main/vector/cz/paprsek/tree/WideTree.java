package cz.paprsek.tree;

import jdk.incubator.vector.ByteVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * A tree for machines with vectors: all children of a node are asked about at once. A virtual machine has one kind, so that what is called here is foreseen. Which children are met
 * are bits of a long, as far apart as leaves room for all, see {@link WideNodes#lane}.
 */
abstract class WideTree extends Tree {
    /** How many children a node has room for: as many as vectors hold floats, 8 or 16. */
    static final int WIDTH = FloatVector.SPECIES_PREFERRED.length() >= 16 ? 16 : 8;
    static final boolean ARE_SIXTEEN = WIDTH == 16;
    static final VectorSpecies<Float> FLOATS = ARE_SIXTEEN ? FloatVector.SPECIES_512 : FloatVector.SPECIES_256;
    static final VectorSpecies<Integer> INTS = ARE_SIXTEEN ? IntVector.SPECIES_512 : IntVector.SPECIES_256;
    /** What holds a byte for each lane, and what eight of its bytes each are read from as one number: of one long there are no vectors in Java 17. */
    static final VectorSpecies<Byte> BYTES = ARE_SIXTEEN ? ByteVector.SPECIES_128 : ByteVector.SPECIES_64;
    static final VectorSpecies<Long> LONGS = LongVector.SPECIES_128;
    /** Where in a node the names of the children begin. */
    private static final int NAMES = 6 * WIDTH;
    /** A bit for each child, and how far they are apart, as a power of two. */
    private static final long ALL = ARE_SIXTEEN ? 0x1111_1111_1111_1111L : 0x0101_0101_0101_0101L;
    private static final int STRIDE = WideNodes.EACH * WIDTH;
    private static final int APART = ARE_SIXTEEN ? 2 : 3;

    /** What is visited next if nothing is left; no leaf has that name. */
    static final int NOTHING = 0;
    /** In place of a node: goes on with those to visit. */
    static final int NEXT = -1;

    /** So many leaves are met by all lines of a frustum at once; where there are more, lines meet so few of their items that each line looks for its own. */
    private static final int ENOUGH = 48;

    private final WideNodes nodes;
    final float[] data;

    WideTree(WideNodes nodes) {
        super(WideNodes.FIRST, nodes.depth);
        this.nodes = nodes;
        this.data = nodes.data;
        whole().point(data);
    }

    @Override
    public void enter(Bundle bundle, Entries entries) {
        open(bundle, entries);
        entries.gather(data, WIDTH);
    }

    private void open(Bundle bundle, Entries entries) {
        entries.startWith(whole());
        nodes.open(bundle, entries);
    }

    @Override
    public void enter(Bundle bundle, Entries entries, Leaves taker) {
        // Of a leaf that is alone no box is known.
        if (depth > 1 && bundle.frustum().aim(nodes, 3 * WIDTH)) {
            open(bundle.frustum(), entries, taker);
        } else {
            open(bundle, entries);
            entries.offer(taker);
        }
        entries.gather(data, WIDTH);
    }

    private void open(Frustum frustum, Entries entries, Leaves taker) {
        entries.clear();
        int met = 0;
        int top = push(frustum, WideNodes.FIRST, 0);
        while (top > 0) {
            int at = frustum.box[--top];
            double near = frustum.near[top];
            if (near >= taker.reach()) {
                continue;
            }
            int lane = (at - WideNodes.FIRST) % WIDTH;
            int subtree = name(data, at - lane, WideNodes.slot(WIDTH, lane));
            if (subtree >= 0 && met < ENOUGH && entries.canHold(top + WIDTH)) {
                top = push(frustum, subtree, top);
            } else if (subtree < 0 && taker.take(first(subtree), end(subtree))) {
                met++;
            } else {
                entries.add(subtree, isQuick(subtree) ? Entries.ANYWHERE : at, Math.max(0, near));
            }
        }
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
        IntVector a = FloatVector.fromArray(FLOATS, nodeData, node + atX[0]).mul(x[0]).add(FloatVector.fromArray(FLOATS, nodeData, node + atY[0]).mul(y[0]))
                .add(FloatVector.fromArray(FLOATS, nodeData, node + atZ[0]).mul(z[0])).add(w[0]).reinterpretAsInts();
        IntVector b = FloatVector.fromArray(FLOATS, nodeData, node + atX[1]).mul(x[1]).add(FloatVector.fromArray(FLOATS, nodeData, node + atY[1]).mul(y[1]))
                .add(FloatVector.fromArray(FLOATS, nodeData, node + atZ[1]).mul(z[1])).add(w[1]).reinterpretAsInts();
        IntVector c = FloatVector.fromArray(FLOATS, nodeData, node + atX[2]).mul(x[2]).add(FloatVector.fromArray(FLOATS, nodeData, node + atY[2]).mul(y[2]))
                .add(FloatVector.fromArray(FLOATS, nodeData, node + atZ[2]).mul(z[2])).add(w[2]).reinterpretAsInts();
        IntVector d = FloatVector.fromArray(FLOATS, nodeData, node + atX[3]).mul(x[3]).add(FloatVector.fromArray(FLOATS, nodeData, node + atY[3]).mul(y[3]))
                .add(FloatVector.fromArray(FLOATS, nodeData, node + atZ[3]).mul(z[3])).add(w[3]).reinterpretAsInts();
        // Outside a plane is what lies below zero.
        LongVector outside = a.lanewise(VectorOperators.OR, b).lanewise(VectorOperators.OR, c.lanewise(VectorOperators.OR, d)).lanewise(VectorOperators.LSHR, 31)
                .convertShape(VectorOperators.I2B, BYTES, 0).reinterpretShape(LONGS, 0).reinterpretAsLongs();
        int top = from;
        for (long hits = (ARE_SIXTEEN ? outside.lane(0) | outside.lane(1) << 4 : outside.lane(0)) ^ ALL; hits != 0; hits &= hits - 1) {
            int slot = slot(hits);
            // The boxes of slots without a child are no number.
            if (name(nodeData, node, slot) == NOTHING) {
                break;
            }
            frustum.push(nodeData, node + WideNodes.lane(WIDTH, slot), from, top++);
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
            LongVector met = in.sub(WideProbe.SLACK + 1).sub(out).lanewise(VectorOperators.LSHR, 31)
                    .convertShape(VectorOperators.I2B, BYTES, 0).reinterpretShape(LONGS, 0).reinterpretAsLongs();
            long hits = ARE_SIXTEEN ? met.lane(0) | met.lane(1) << 4 : met.lane(0);
            if (hits == 0) {
                node = NEXT;
                continue;
            }
            // Mostly there is one, which need not go over the stack.
            if ((hits & hits - 1) == 0) {
                node = name(nodeData, node, slot(hits));
            } else {
                in.intoArray(enters, 0);
                node = putDown(stack, top, enters, nodeData, node, hits);
                top += Long.bitCount(hits) - 1;
            }
            if (node < 0) {
                probe.top = top;
                search.visits += visits + 1;
                return node;
            }
            nodeData = data;
        }
    }

    /**
     * Puts children of a node that are met upon those to be visited, but for the nearest, and returns its name.
     *
     * @param enters where the line enters each, by lane
     * @param met which of them, two at least
     */
    abstract int putDown(long[] stack, int top, int[] enters, float[] from, int node, long met);

    /**
     * Visits nodes until some leaves are found, in any order, and returns in how many places: they are named in {@link Search#leaves}. Several at once, since whoever asks
     * whether anything is met mostly has to ask them all.
     */
    abstract int leaves(WideProbe probe, Search<?> search, float[] from, int first);

    /** Asks what was found in one place; true ends the search. */
    abstract <R> boolean stopsAt(Search<R> search, R ray, int place);

    /** The first child of those met. */
    static int slot(long hits) {
        return Long.numberOfTrailingZeros(hits) >>> APART;
    }

    static int name(float[] data, int node, int slot) {
        return Float.floatToRawIntBits(data[node + NAMES + slot]);
    }
}
