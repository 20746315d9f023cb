package cz.paprsek.shape.mesh;

import java.util.Arrays;
import java.util.BitSet;

/**
 * The edges of triangles between places, each known by both of its ends: which triangles pass it, and in which direction. Those of a triangle
 * with two corners in one place are left out: it is there and back again.
 */
final class Edges {
    private static final int NONE = -1;

    private final int triangles;
    /** The passages that begin or end at a place and go to or come from a higher one stand side by side: those of place p from start[p] to start[p + 1] − 1. */
    private final int[] start;
    private final int[] higher;
    /** Three times the triangle plus which of its sides; the complement if it comes from the higher place. */
    private final int[] passage;

    /**
     * @param first for each vertex the first one in its place
     * @param corners of the triangles
     */
    Edges(int[] first, int[] corners) {
        triangles = corners.length / 3;
        start = new int[first.length + 1];
        for (int side = 0; side < corners.length; side++) {
            int low = low(first, corners, side);
            if (low != NONE) {
                start[low + 1]++;
            }
        }
        for (int p = 0; p < first.length; p++) {
            start[p + 1] += start[p];
        }
        higher = new int[start[first.length]];
        passage = new int[higher.length];
        for (int side = 0; side < corners.length; side++) {
            int low = low(first, corners, side);
            if (low != NONE) {
                int from = first[corners[side]];
                int to = first[corners[next(side)]];
                int at = start[low]++;
                higher[at] = Math.max(from, to);
                passage[at] = from < to ? side : ~side;
            }
        }
        System.arraycopy(start, 0, start, 1, first.length);
        start[0] = 0;
        for (int p = 0; p < first.length; p++) {
            sort(start[p], start[p + 1]);
        }
    }

    private static int next(int side) {
        return side % 3 == 2 ? side - 2 : side + 1;
    }

    /** The lower one of the places between which a side leads, unless its triangle has two corners in one. */
    private static int low(int[] first, int[] corners, int side) {
        int t = side / 3 * 3;
        int a = first[corners[t]];
        int b = first[corners[t + 1]];
        int c = first[corners[t + 2]];
        if (a == b || b == c || c == a) {
            return NONE;
        }
        return Math.min(first[corners[side]], first[corners[next(side)]]);
    }

    /** By the higher place; there are a handful at each, but a fan may have any number. */
    private void sort(int from, int to) {
        if (to - from > 64) {
            sortMany(from, to);
            return;
        }
        for (int i = from + 1; i < to; i++) {
            int place = higher[i];
            int its = passage[i];
            int j = i;
            for (; j > from && higher[j - 1] > place; j--) {
                higher[j] = higher[j - 1];
                passage[j] = passage[j - 1];
            }
            higher[j] = place;
            passage[j] = its;
        }
    }

    private void sortMany(int from, int to) {
        long[] both = new long[to - from];
        for (int i = from; i < to; i++) {
            both[i - from] = ((long) higher[i] << 32) | (passage[i] & 0xFFFFFFFFL);
        }
        Arrays.sort(both);
        for (int i = from; i < to; i++) {
            higher[i] = (int) (both[i - from] >> 32);
            passage[i] = (int) both[i - from];
        }
    }

    /** How many edges are not passed as often in one direction as in the other, if some triangles are turned round. */
    int open(BitSet turned) {
        int open = 0;
        for (int p = 0; p + 1 < start.length; p++) {
            int i = start[p];
            while (i < start[p + 1]) {
                int end = end(i, start[p + 1]);
                int balance = 0;
                for (; i < end; i++) {
                    balance += isForward(i) == turned.get(triangle(i)) ? -1 : 1;
                }
                open += balance == 0 ? 0 : 1;
            }
        }
        return open;
    }

    /** The places that open edges lead between, if some triangles are turned round. */
    BitSet rim(BitSet turned) {
        BitSet rim = new BitSet();
        for (int p = 0; p + 1 < start.length; p++) {
            int i = start[p];
            while (i < start[p + 1]) {
                int end = end(i, start[p + 1]);
                int balance = 0;
                int other = higher[i];
                for (; i < end; i++) {
                    balance += isForward(i) == turned.get(triangle(i)) ? -1 : 1;
                }
                if (balance != 0) {
                    rim.set(p);
                    rim.set(other);
                }
            }
        }
        return rim;
    }

    /** Where those of the edge end that begin at i. */
    private int end(int i, int most) {
        int end = i + 1;
        while (end < most && higher[end] == higher[i]) {
            end++;
        }
        return end;
    }

    private boolean isForward(int i) {
        return passage[i] >= 0;
    }

    private int triangle(int i) {
        return (passage[i] < 0 ? ~passage[i] : passage[i]) / 3;
    }

    /**
     * Turns triangles so that they fit to their neighbours, from triangle to triangle across edges that have just two; of those that hang together
     * in this way, the fewer.
     *
     * @return whether any are turned
     */
    boolean fit(BitSet turned) {
        // Across each side the neighbour's number; its complement if both pass the edge in one direction.
        int[] across = new int[3 * triangles];
        Arrays.fill(across, Integer.MIN_VALUE);
        for (int p = 0; p + 1 < start.length; p++) {
            int i = start[p];
            while (i < start[p + 1]) {
                int end = end(i, start[p + 1]);
                if (end - i == 2) {
                    boolean same = isForward(i) == isForward(i + 1);
                    across[side(i)] = same ? ~triangle(i + 1) : triangle(i + 1);
                    across[side(i + 1)] = same ? ~triangle(i) : triangle(i);
                }
                i = end;
            }
        }
        BitSet seen = new BitSet(triangles);
        int[] queue = new int[triangles];
        for (int t = seen.nextClearBit(0); t < triangles; t = seen.nextClearBit(t)) {
            int count = spread(t, across, seen, queue, turned);
            int turns = 0;
            for (int i = 0; i < count; i++) {
                turns += turned.get(queue[i]) ? 1 : 0;
            }
            for (int i = 0; i < count && 2L * turns > count; i++) {
                turned.flip(queue[i]);
            }
        }
        return !turned.isEmpty();
    }

    /** Goes from a triangle to all that hang together with it, and turns those that do not fit to where it comes from; they stand in the queue then. */
    private static int spread(int from, int[] across, BitSet seen, int[] queue, BitSet turned) {
        int count = 0;
        queue[count++] = from;
        seen.set(from);
        for (int i = 0; i < count; i++) {
            int t = queue[i];
            for (int k = 0; k < 3; k++) {
                int neighbour = across[3 * t + k];
                if (neighbour != Integer.MIN_VALUE) {
                    boolean same = neighbour < 0;
                    int other = same ? ~neighbour : neighbour;
                    if (!seen.get(other)) {
                        seen.set(other);
                        turned.set(other, same != turned.get(t));
                        queue[count++] = other;
                    }
                }
            }
        }
        return count;
    }

    /** What is done with an edge: two sides of triangles that are on it, the second −1 if it has not just two. */
    @FunctionalInterface
    interface Visitor {
        void visit(int side, int other);
    }

    /** Visits every edge once. */
    void each(Visitor visitor) {
        for (int p = 0; p + 1 < start.length; p++) {
            int i = start[p];
            while (i < start[p + 1]) {
                int end = end(i, start[p + 1]);
                visitor.visit(side(i), end - i == 2 ? side(i + 1) : NONE);
                i = end;
            }
        }
    }

    private int side(int i) {
        return passage[i] < 0 ? ~passage[i] : passage[i];
    }
}
