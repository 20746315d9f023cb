package cz.paprsek.tree;

import jdk.incubator.vector.ByteVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/** The tree for machines with vectors of sixteen floats. What is met are bits of a long, four for each child, see {@link WideNodes#lane}. */
final class SixteenTree extends WideTree {
    static final int WIDTH = 16;
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_512;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_512;
    /** What holds a byte for each lane, and what eight of its bytes each are read from as one number. */
    private static final VectorSpecies<Byte> BYTES = ByteVector.SPECIES_128;
    private static final VectorSpecies<Long> LONGS = LongVector.SPECIES_128;
    /** Of so many nodes the children that are leaves are asked at once. */
    private static final int SOME = 2;
    /** Where in a node the names of the children begin. */
    private static final int NAMES = 6 * WIDTH;
    /** A bit for each child. */
    private static final long ALL = 0x1111_1111_1111_1111L;

    SixteenTree(BinaryNodes nodes) {
        super(new WideNodes(nodes, WIDTH));
    }

    @Override
    int push(Frustum frustum, int node, int from) {
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
        LongVector outside = a.reinterpretAsInts().lanewise(VectorOperators.OR, b.reinterpretAsInts())
                .lanewise(VectorOperators.OR, c.reinterpretAsInts().lanewise(VectorOperators.OR, d.reinterpretAsInts())).lanewise(VectorOperators.LSHR, 31)
                .convertShape(VectorOperators.I2B, BYTES, 0).reinterpretShape(LONGS, 0).reinterpretAsLongs();
        int top = from;
        for (long hits = (outside.lane(0) | outside.lane(1) << 4) ^ ALL; hits != 0; hits &= hits - 1) {
            int slot = Long.numberOfTrailingZeros(hits) >>> 2;
            // The boxes of slots without a child are no number.
            if (Float.floatToRawIntBits(nodeData[node + NAMES + slot]) == NOTHING) {
                break;
            }
            frustum.push(nodeData, node + WideNodes.lane(WIDTH, slot), from, top++);
        }
        return top;
    }

    @Override
    int name(int at) {
        int lane = (at - WideNodes.FIRST) % WIDTH;
        return Float.floatToRawIntBits(data[at - lane + NAMES + WideNodes.slot(WIDTH, lane)]);
    }

    @Override
    int next(WideProbe probe, Search<?> search, float[] from, int first) {
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
            IntVector lessX = FloatVector.fromArray(FLOATS, nodeData, node).sub(lowX).mul(rx).reinterpretAsInts();
            IntVector moreX = FloatVector.fromArray(FLOATS, nodeData, node + 3 * WIDTH).sub(highX).mul(rx).reinterpretAsInts();
            IntVector lessY = FloatVector.fromArray(FLOATS, nodeData, node + WIDTH).sub(lowY).mul(ry).reinterpretAsInts();
            IntVector moreY = FloatVector.fromArray(FLOATS, nodeData, node + 4 * WIDTH).sub(highY).mul(ry).reinterpretAsInts();
            IntVector lessZ = FloatVector.fromArray(FLOATS, nodeData, node + 2 * WIDTH).sub(lowZ).mul(rz).reinterpretAsInts();
            IntVector moreZ = FloatVector.fromArray(FLOATS, nodeData, node + 5 * WIDTH).sub(highZ).mul(rz).reinterpretAsInts();
            IntVector in = lessX.min(moreX).max(lessY.min(moreY)).max(lessZ.min(moreZ).max(begin));
            IntVector out = lessX.max(moreX).min(lessY.max(moreY)).min(lessZ.max(moreZ).min(end)).max(-1 - WideProbe.SLACK);
            LongVector met = in.sub(WideProbe.SLACK + 1).sub(out).lanewise(VectorOperators.LSHR, 31)
                    .convertShape(VectorOperators.I2B, BYTES, 0).reinterpretShape(LONGS, 0).reinterpretAsLongs();
            long hits = met.lane(0) | met.lane(1) << 4;
            if (hits == 0) {
                node = NEXT;
                continue;
            }
            // From the last on: boxes to begin with stand in the order of their distance.
            int bit = 63 - Long.numberOfLeadingZeros(hits);
            int slot = bit >>> 2;
            int name = Float.floatToRawIntBits(nodeData[node + NAMES + slot]);
            hits ^= 1L << bit;
            if (hits != 0) {
                // The nearest is gone on with, the others are put down. Which is nearer is told without a branch, and where a lane stands (see WideNodes) written
                // here, since a call would be one.
                in.intoArray(enters, 0);
                long nearest = (long) enters[slot >> 1 | (slot & 1) << 3] << 32 | name & 0xFFFFFFFFL;
                do {
                    bit = 63 - Long.numberOfLeadingZeros(hits);
                    slot = bit >>> 2;
                    hits ^= 1L << bit;
                    long entry = (long) enters[slot >> 1 | (slot & 1) << 3] << 32 | Float.floatToRawIntBits(nodeData[node + NAMES + slot]) & 0xFFFFFFFFL;
                    long less = entry - nearest;
                    less &= less >> 63;
                    stack[top++] = entry - less;
                    nearest += less;
                } while (hits != 0);
                name = (int) nearest;
            }
            if (name < 0) {
                probe.top = top;
                search.visits += visits + 1;
                return name;
            }
            node = name;
            nodeData = data;
        }
    }

    /**
     * {@inheritDoc} In each place there is a leaf, or a node and which of its children are leaves that are met.
     * <p>
     * From one node to the next there is no branch: what is met cannot be foretold. The children of a node that are to be visited are bits of one number, of which
     * the lowest tells where the next node is, as nodes of one parent stand side by side; if none is left, those of another node are taken up again. On the stack
     * are such numbers, each below where the first child is, and two zeros below all.
     */
    @Override
    int leaves(WideProbe probe, Search<?> search, float[] from, int first) {
        if (first == NEXT && probe.top == 0) {
            return 0;
        }
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
        int[] leaves = search.leaves;
        long[] which = search.which;
        float[] nodeData = from;
        long left = 1;
        int base = first;
        int top = 2;
        int visits = -1;
        if (first == NEXT) {
            nodeData = data;
            top = probe.top;
            left = stack[top];
            base = (int) stack[top + 1];
            visits = 0;
        } else {
            stack[0] = 0;
            stack[1] = 0;
        }
        int found = 0;
        do {
            visits++;
            int node = base + (Long.numberOfTrailingZeros(left) << 5);
            left &= left - 1;
            // What is left of these children is put down, and stays there if it is any.
            stack[top] = left;
            stack[top + 1] = base;
            top += (int) ((left | -left) >>> 63) << 1;
            IntVector lessX = FloatVector.fromArray(FLOATS, nodeData, node).sub(lowX).mul(rx).reinterpretAsInts();
            IntVector moreX = FloatVector.fromArray(FLOATS, nodeData, node + 3 * WIDTH).sub(highX).mul(rx).reinterpretAsInts();
            IntVector lessY = FloatVector.fromArray(FLOATS, nodeData, node + WIDTH).sub(lowY).mul(ry).reinterpretAsInts();
            IntVector moreY = FloatVector.fromArray(FLOATS, nodeData, node + 4 * WIDTH).sub(highY).mul(ry).reinterpretAsInts();
            IntVector lessZ = FloatVector.fromArray(FLOATS, nodeData, node + 2 * WIDTH).sub(lowZ).mul(rz).reinterpretAsInts();
            IntVector moreZ = FloatVector.fromArray(FLOATS, nodeData, node + 5 * WIDTH).sub(highZ).mul(rz).reinterpretAsInts();
            IntVector in = lessX.min(moreX).max(lessY.min(moreY)).max(lessZ.min(moreZ).max(begin));
            IntVector out = lessX.max(moreX).min(lessY.max(moreY)).min(lessZ.max(moreZ).min(end)).max(-1 - WideProbe.SLACK);
            LongVector met = in.sub(WideProbe.SLACK + 1).sub(out).lanewise(VectorOperators.LSHR, 31)
                    .convertShape(VectorOperators.I2B, BYTES, 0).reinterpretShape(LONGS, 0).reinterpretAsLongs();
            long hits = met.lane(0) | met.lane(1) << 4;
            long inner = 0;
            int next = 0;
            if (nodeData == data) {
                int shift = Float.floatToRawIntBits(nodeData[node + 7 * WIDTH]);
                next = Float.floatToRawIntBits(nodeData[node + NAMES]);
                inner = hits & (-1L >>> shift >>> shift);
                long outer = hits ^ inner;
                leaves[found] = node;
                which[found] = outer;
                found += (int) ((outer | -outer) >>> 63);
            } else {
                // Boxes to begin with, whose nodes stand anywhere.
                nodeData = data;
                for (; hits != 0; hits &= hits - 1) {
                    int name = Float.floatToRawIntBits(from[node + NAMES + (Long.numberOfTrailingZeros(hits) >>> 2)]);
                    leaves[found] = name;
                    which[found] = 1;
                    found += name >>> 31;
                    stack[top] = 1;
                    stack[top + 1] = name;
                    top += ~name >>> 31 << 1;
                }
            }
            long mask = (inner | -inner) >> 63;
            left = inner | stack[top - 2] & ~mask;
            base = next & (int) mask | (int) stack[top - 1] & ~(int) mask;
            top -= ~(int) mask & 2;
        } while (left != 0 && found < SOME);
        stack[top] = left;
        stack[top + 1] = base;
        probe.top = left == 0 ? 0 : top;
        search.visits += visits;
        return found;
    }

    @Override
    <R> boolean stopsAt(Search<R> search, R ray, int place) {
        int at = search.leaves[place];
        for (long left = search.which[place]; left != 0; left &= left - 1) {
            int leaf = at < 0 ? at : Float.floatToRawIntBits(data[at + NAMES + (Long.numberOfTrailingZeros(left) >>> 2)]);
            search.visits++;
            if (search.stopsAt(ray, first(leaf), end(leaf))) {
                return true;
            }
        }
        return false;
    }
}
