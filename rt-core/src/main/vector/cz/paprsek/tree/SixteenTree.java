package cz.paprsek.tree;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;

/** The tree for machines with vectors of sixteen floats. */
final class SixteenTree extends WideTree {
    /** Of so many nodes the children that are leaves are asked at once. */
    private static final int SOME = 2;

    SixteenTree(BinaryNodes nodes) {
        super(new WideNodes(nodes, WIDTH));
    }

    /**
     * None sorted, and from the last on: boxes to begin with stand in the order of their distance. Which is nearer is told without a branch, and where a lane stands (see
     * {@link WideNodes}) written here, since a call would be one.
     */
    @Override
    int putDown(long[] stack, int bottom, int[] enters, float[] from, int node, long met) {
        int bit = 63 - Long.numberOfLeadingZeros(met);
        int slot = bit >>> 2;
        long nearest = (long) enters[slot >> 1 | (slot & 1) << 3] << 32 | name(from, node, slot) & 0xFFFFFFFFL;
        int top = bottom;
        long hits = met ^ 1L << bit;
        do {
            bit = 63 - Long.numberOfLeadingZeros(hits);
            slot = bit >>> 2;
            hits ^= 1L << bit;
            long less = ((long) enters[slot >> 1 | (slot & 1) << 3] << 32 | name(from, node, slot) & 0xFFFFFFFFL) - nearest;
            long nearer = less & less >> 63;
            stack[top++] = nearest + less - nearer;
            nearest += nearer;
        } while (hits != 0);
        return (int) nearest;
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
                next = name(nodeData, node, 0);
                inner = hits & (-1L >>> shift >>> shift);
                long outer = hits ^ inner;
                leaves[found] = node;
                which[found] = outer;
                found += (int) ((outer | -outer) >>> 63);
            } else {
                // Boxes to begin with, whose nodes stand anywhere.
                nodeData = data;
                for (; hits != 0; hits &= hits - 1) {
                    int name = name(from, node, slot(hits));
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
            int leaf = at < 0 ? at : name(data, at, slot(left));
            search.visits++;
            if (search.stopsAt(ray, first(leaf), end(leaf))) {
                return true;
            }
        }
        return false;
    }
}
