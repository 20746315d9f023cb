package cz.paprsek.tree;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;

/** The tree for machines with vectors of eight floats. */
final class EightTree extends WideTree {
    EightTree(BinaryNodes nodes) {
        super(new WideNodes(nodes, WIDTH));
    }

    /** All of them sorted. */
    @Override
    int putDown(long[] stack, int bottom, int[] enters, float[] from, int node, long met) {
        int top = bottom;
        for (long hits = met; hits != 0; hits &= hits - 1) {
            int slot = slot(hits);
            long entry = (long) enters[slot] << 32 | name(from, node, slot) & 0xFFFFFFFFL;
            int place = top++;
            for (; place > bottom && stack[place - 1] < entry; place--) {
                stack[place] = stack[place - 1];
            }
            stack[place] = entry;
        }
        return (int) stack[top - 1];
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
                int next = name(nodeData, node, slot(hits));
                for (long others = hits & hits - 1; others != 0; others &= others - 1) {
                    int name = name(nodeData, node, slot(others));
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
}
