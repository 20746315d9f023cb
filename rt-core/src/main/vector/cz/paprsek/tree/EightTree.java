package cz.paprsek.tree;

import jdk.incubator.vector.ByteVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/** The tree for machines with vectors of eight floats: all children of a node are asked about at once. */
final class EightTree extends WideTree {
    static final int WIDTH = 8;
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    /** What holds a byte for each lane, and what the first eight of its bytes are read from as one number: of one long there are no vectors in Java 17. */
    private static final VectorSpecies<Byte> BYTES = ByteVector.SPECIES_64;
    private static final VectorSpecies<Long> LONGS = LongVector.SPECIES_128;
    /** Where in a node the names of the children begin. */
    private static final int NAMES = 6 * WIDTH;
    /** A one in each of eight bytes. */
    private static final long ALL = 0x0101_0101_0101_0101L;

    EightTree(BinaryNodes nodes) {
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
    int name(int at) {
        return name(data, at, 0);
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

    @Override
    int leaves(WideProbe probe, Search<?> search, float[] from, int first) {
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

    @Override
    <R> boolean stopsAt(Search<R> search, R ray, int place) {
        int leaf = search.leaves[place];
        return search.stopsAt(ray, first(leaf), end(leaf));
    }

    private static int name(float[] data, int node, int slot) {
        return Float.floatToRawIntBits(data[node + NAMES + slot]);
    }
}
