package cz.paprsek.tree;

import jdk.incubator.vector.ByteVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/** The tree for large meshes and the like, which memory is waited for: boxes are of half the size, and nodes of sixteen children where vectors hold as many floats, else of eight. Searches are of the whole. */
final class PackedTree extends Tree {
    /** How many children a node has room for: 8 or 16. */
    static final int WIDTH = FloatVector.SPECIES_PREFERRED.length() >= 16 ? 16 : 8;
    private static final boolean ARE_SIXTEEN = WIDTH == 16;
    private static final VectorSpecies<Float> FLOATS = ARE_SIXTEEN ? FloatVector.SPECIES_512 : FloatVector.SPECIES_256;
    /** What planes are read as: ints of two each. */
    private static final VectorSpecies<Integer> PAIRS = ARE_SIXTEEN ? IntVector.SPECIES_256 : IntVector.SPECIES_128;
    /** What holds a byte for each lane, and what they are read from as one number or two. */
    private static final VectorSpecies<Byte> BYTES = ARE_SIXTEEN ? ByteVector.SPECIES_128 : ByteVector.SPECIES_64;
    private static final VectorSpecies<Long> LONGS = LongVector.SPECIES_128;
    /** Where in a node the names of the children begin. */
    private static final int NAMES = 3 * WIDTH;
    /** What is visited next if nothing is left; no leaf has that name. */
    private static final int NOTHING = 0;
    /** In place of a node: goes on with those to visit. */
    private static final int NEXT = -1;

    private final PackedNodes nodes;
    private final int[] data;

    PackedTree(PackedNodes nodes) {
        super(PackedNodes.FIRST, nodes.depth);
        this.nodes = nodes;
        this.data = nodes.data;
    }

    @Override
    public void enter(Bundle bundle, Entries entries) {
        entries.startWith(whole());
    }

    @Override
    public <R> void nearest(Search<R> search, R ray, Entries entries, double end) {
        WideProbe probe = search.aimAt(nodes, ray);
        if (probe.meetsAll()) {
            for (int i = 0; i < nodes.items; i += LEAF) {
                search.meet(ray, i, Math.min(nodes.items, i + LEAF));
            }
            return;
        }
        int leaf = next(probe, search, PackedNodes.FIRST);
        while (leaf != NOTHING) {
            probe.end(search.meet(ray, first(leaf), end(leaf)));
            leaf = next(probe, search, NEXT);
        }
    }

    @Override
    public <R> boolean any(Search<R> search, R ray, Entries entries) {
        WideProbe probe = search.aimAt(nodes, ray);
        if (probe.meetsAll()) {
            for (int i = 0; i < nodes.items; i += LEAF) {
                if (search.stopsAt(ray, i, Math.min(nodes.items, i + LEAF))) {
                    return true;
                }
            }
            return false;
        }
        int found = leaves(probe, search, PackedNodes.FIRST);
        while (found > 0) {
            for (int i = 0; i < found; i++) {
                if (search.stopsAt(ray, first(search.leaves[i]), end(search.leaves[i]))) {
                    return true;
                }
            }
            found = leaves(probe, search, NEXT);
        }
        return false;
    }

    /** Visits nodes up to the next leaf, the nearest first as far as boxes tell, and returns its name, or {@link #NOTHING}. */
    private int next(WideProbe probe, Search<?> search, int first) {
        long[] stack = probe.stack;
        int[] enters = probe.lanes;
        int[] nodeData = data;
        int farthest = probe.end + WideProbe.SLACK;
        int node = first;
        int top = probe.top;
        int visits = 0;
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
            }
            visits++;
            long hits = met(probe, nodeData, node);
            // Mostly there is one, which need not go over the stack.
            if ((hits & hits - 1) == 0 && hits != 0) {
                node = nodeData[node + NAMES + slot(hits)];
                if (node < 0) {
                    probe.top = top;
                    search.visits += visits + 1;
                    return node;
                }
                continue;
            }
            int bottom = top;
            for (; hits != 0; hits &= hits - 1) {
                int slot = slot(hits);
                long entry = (long) enters[slot] << 32 | nodeData[node + NAMES + slot] & 0xFFFFFFFFL;
                int place = top++;
                for (; place > bottom && stack[place - 1] < entry; place--) {
                    stack[place] = stack[place - 1];
                }
                stack[place] = entry;
            }
            node = NEXT;
        }
    }

    /** Visits nodes until some leaves are found, in any order, and returns how many: they are named in {@link Search#leaves}. */
    private int leaves(WideProbe probe, Search<?> search, int first) {
        int top = probe.top;
        if (first == NEXT && top == 0) {
            return 0;
        }
        long[] stack = probe.stack;
        int[] leaves = search.leaves;
        int[] nodeData = data;
        int node = first == NEXT ? (int) stack[--top] : first;
        int found = 0;
        int visits = 0;
        while (true) {
            visits++;
            long hits = met(probe, nodeData, node);
            if (hits != 0) {
                int next = nodeData[node + NAMES + slot(hits)];
                for (long others = hits & hits - 1; others != 0; others &= others - 1) {
                    int name = nodeData[node + NAMES + slot(others)];
                    // Both are written, and one stays: no branch, which could not be foretold.
                    leaves[found] = name;
                    stack[top] = name;
                    found += name >>> 31;
                    top += ~name >>> 31;
                }
                // Mostly there is one, which need not go over the stack.
                if (next >= 0 && found < Search.SOME) {
                    node = next;
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
        }
    }

    /**
     * Which children of a node the line meets: a bit each, from the lowest of which {@link #slot} tells the child. Where it enters them stands in the probe then. Vectors live in this method only: handed
     * on, they would become objects. It is too long to be put into those that call it, of which C2 would inline but a part.
     */
    private static long met(WideProbe probe, int[] data, int node) {
        int firstX = probe.firstX;
        int firstY = probe.firstY;
        int firstZ = probe.firstZ;
        FloatVector rx = FloatVector.broadcast(FLOATS, probe.rx);
        FloatVector ry = FloatVector.broadcast(FLOATS, probe.ry);
        FloatVector rz = FloatVector.broadcast(FLOATS, probe.rz);
        IntVector in = ((FloatVector) IntVector.fromArray(PAIRS, data, node + firstX).reinterpretAsShorts().convertShape(VectorOperators.S2F, FLOATS, 0))
                .fma(rx, FloatVector.broadcast(FLOATS, probe.nearX)).reinterpretAsInts()
                .max(((FloatVector) IntVector.fromArray(PAIRS, data, node + firstY).reinterpretAsShorts().convertShape(VectorOperators.S2F, FLOATS, 0))
                        .fma(ry, FloatVector.broadcast(FLOATS, probe.nearY)).reinterpretAsInts())
                .max(((FloatVector) IntVector.fromArray(PAIRS, data, node + firstZ).reinterpretAsShorts().convertShape(VectorOperators.S2F, FLOATS, 0))
                        .fma(rz, FloatVector.broadcast(FLOATS, probe.nearZ)).reinterpretAsInts().max(probe.begin));
        IntVector out = ((FloatVector) IntVector.fromArray(PAIRS, data, node + 3 * WIDTH / 2 - firstX).reinterpretAsShorts().convertShape(VectorOperators.S2F, FLOATS, 0))
                .fma(rx, FloatVector.broadcast(FLOATS, probe.farX)).reinterpretAsInts()
                .min(((FloatVector) IntVector.fromArray(PAIRS, data, node + 5 * WIDTH / 2 - firstY).reinterpretAsShorts().convertShape(VectorOperators.S2F, FLOATS, 0))
                        .fma(ry, FloatVector.broadcast(FLOATS, probe.farY)).reinterpretAsInts())
                .min(((FloatVector) IntVector.fromArray(PAIRS, data, node + 7 * WIDTH / 2 - firstZ).reinterpretAsShorts().convertShape(VectorOperators.S2F, FLOATS, 0))
                        .fma(rz, FloatVector.broadcast(FLOATS, probe.farZ)).reinterpretAsInts().min(probe.end))
                .max(-1 - WideProbe.SLACK);
        in.intoArray(probe.lanes, 0);
        // A byte for each lane, 1 where in ≤ out + slack.
        LongVector met = in.sub(WideProbe.SLACK + 1).sub(out).lanewise(VectorOperators.LSHR, 31)
                .convertShape(VectorOperators.I2B, BYTES, 0).reinterpretShape(LONGS, 0).reinterpretAsLongs();
        return ARE_SIXTEEN ? met.lane(0) | met.lane(1) << 4 : met.lane(0);
    }

    /** The child that the lowest bit means: bits 8i mean the children i, bits 8i + 4 the children 8 + i. */
    private static int slot(long hits) {
        int bit = Long.numberOfTrailingZeros(hits);
        return bit >>> 3 | (bit & 4) << 1;
    }
}
