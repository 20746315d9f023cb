package cz.paprsek.tree;

import java.util.function.BooleanSupplier;

/**
 * Scratch of one task that builds a tree: finds where records had better be parted in two, by the surface area heuristic, and parts them.
 * A record is a box in whole numbers from 0 to {@link #SIDE}, coarse but quick: processors take the smaller of two of these without a guess.
 * All three axes are looked at in one pass; what is to be known of both parts comes out of that pass, and of the one that moves records.
 */
final class Bins {
    /** The largest number in a record: twice as much is still a whole number. */
    static final int SIDE = (1 << 30) - 1;
    /** The most bins; few records get one each. */
    private static final int BINS = 16;
    /** Below this depth trees are halved, and a half of {@link Integer#MAX_VALUE} records is one after 31 times; with room for two to each. */
    private static final int FRAMES = 2 * (TreeBuilder.STEEP + 34);

    /** Six numbers each, and what each record is; both are permuted together. */
    private final int[] records;
    private final int[] items;
    private final BooleanSupplier stop;

    private final int[] count = new int[3 * BINS];
    private final int[] box = new int[3 * BINS * 6];
    /** By how much to multiply what a centre is above the lowest, so that the upper half is the number of its bin; 0 if all centres are one. */
    private final long[] scale = new long[3];
    private final double[] area = new double[BINS];
    private final int[] grown = new int[6];
    private int bins;
    private double bestCost;
    private int bestAxis;
    private int bestBin;

    /**
     * Within which bounds the centres of records lie, twice as large: a frame of six numbers for each set of records that waits to be parted.
     * What was parted from frame f leaves the part with the larger box in frame f + 2, and the other in f + 1, which waits meanwhile.
     */
    private final int[] centres = new int[6 * FRAMES];
    private final int[] left = new int[6];
    private final int[] right = new int[6];

    Bins(int[] records, int[] items, BooleanSupplier stop) {
        this.records = records;
        this.items = items;
        this.stop = stop;
    }

    /** Takes note of the bounds of centres: looks at each record. */
    void measure(int start, int end, int frame) {
        empty(centres, 6 * frame);
        for (int i = start; i < end; i++) {
            growCentres(6 * frame, i);
        }
    }

    /** Finds the plane of least cost; false if all centres coincide. */
    boolean find(int start, int end, int frame) {
        reset(end - start, 6 * frame);
        int lowX = centres[6 * frame];
        int lowY = centres[6 * frame + 1];
        int lowZ = centres[6 * frame + 2];
        long scaleX = scale[0];
        long scaleY = scale[1];
        long scaleZ = scale[2];
        for (int i = start; i < end; i++) {
            TreeBuilder.stopIfAsked(i, stop);
            int minX = records[6 * i];
            int minY = records[6 * i + 1];
            int minZ = records[6 * i + 2];
            int maxX = records[6 * i + 3];
            int maxY = records[6 * i + 4];
            int maxZ = records[6 * i + 5];
            int x = (int) (((minX + maxX - lowX) * scaleX) >> 32);
            int y = BINS + (int) (((minY + maxY - lowY) * scaleY) >> 32);
            int z = 2 * BINS + (int) (((minZ + maxZ - lowZ) * scaleZ) >> 32);
            count[x]++;
            count[y]++;
            count[z]++;
            grow(box, 6 * x, minX, minY, minZ, maxX, maxY, maxZ);
            grow(box, 6 * y, minX, minY, minZ, maxX, maxY, maxZ);
            grow(box, 6 * z, minX, minY, minZ, maxX, maxY, maxZ);
        }
        bestCost = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            if (scale[axis] > 0) {
                sweep(axis, end - start);
            }
        }
        return bestCost < Double.POSITIVE_INFINITY;
    }

    /** What the plane that was found costs, in tests of surfaces if all cost the same, given that the whole is hit. */
    double cost() {
        return bestCost;
    }

    private void reset(int total, int frame) {
        bins = Math.max(4, Math.min(BINS, total));
        for (int axis = 0; axis < 3; axis++) {
            long range = (long) centres[frame + 3 + axis] - centres[frame + axis];
            scale[axis] = range > 0 ? ((long) bins << 32) / (range + 1) : 0;
            for (int bin = axis * BINS; bin < axis * BINS + bins; bin++) {
                count[bin] = 0;
                empty(box, 6 * bin);
            }
        }
    }

    private void sweep(int axis, int total) {
        int first = axis * BINS;
        empty(grown, 0);
        for (int bin = bins - 1; bin > 0; bin--) {
            grow(grown, 0, box, 6 * (first + bin));
            area[bin] = halfArea(grown);
        }
        empty(grown, 0);
        int before = 0;
        double best = Double.POSITIVE_INFINITY;
        int at = 0;
        for (int bin = 1; bin < bins; bin++) {
            grow(grown, 0, box, 6 * (first + bin - 1));
            before += count[first + bin - 1];
            if (before > 0 && before < total) {
                double cost = halfArea(grown) * before + area[bin] * (total - before);
                if (cost < best) {
                    best = cost;
                    at = bin;
                }
            }
        }
        grow(grown, 0, box, 6 * (first + bins - 1));
        double whole = halfArea(grown);
        double cost = whole > 0 ? best / whole : best < Double.POSITIVE_INFINITY ? total : best;
        if (cost < bestCost) {
            bestCost = cost;
            bestAxis = axis;
            bestBin = at;
        }
    }

    /** Moves the records to their sides of the plane that was found, and returns where the right ones begin. */
    int part(int start, int end, int frame) {
        int low = centres[6 * frame + bestAxis];
        int ofLeft = 6 * (frame + 2);
        int ofRight = 6 * (frame + 1);
        empty(centres, ofLeft);
        empty(centres, ofRight);
        int a = start;
        int b = end - 1;
        while (true) {
            while (a <= b && isLeft(a, low)) {
                growCentres(ofLeft, a++);
            }
            while (a <= b && !isLeft(b, low)) {
                growCentres(ofRight, b--);
            }
            if (a > b) {
                break;
            }
            TreeBuilder.stopIfAsked(a, stop);
            swap(a, b);
        }
        empty(left, 0);
        empty(right, 0);
        for (int bin = 0; bin < bins; bin++) {
            grow(bin < bestBin ? left : right, 0, box, 6 * (bestAxis * BINS + bin));
        }
        return a;
    }

    private boolean isLeft(int i, int low) {
        int centre = records[6 * i + bestAxis] + records[6 * i + bestAxis + 3];
        return (int) (((centre - low) * scale[bestAxis]) >> 32) < bestBin;
    }

    /** Makes two parts of records as they stand, and returns where the right one begins. */
    int halve(int start, int end, int frame) {
        int middle = start + (end - start) / 2;
        measure(start, middle, frame + 2);
        measure(middle, end, frame + 1);
        empty(left, 0);
        empty(right, 0);
        for (int i = start; i < end; i++) {
            grow(i < middle ? left : right, 0, records, 6 * i);
        }
        return middle;
    }

    /** Puts what is known of both parts into order; whether the left one is the larger. */
    boolean isLeftLarger(int frame) {
        boolean is = halfArea(left) >= halfArea(right);
        for (int k = 6 * (frame + 1); k < 6 * (frame + 2) && !is; k++) {
            exchange(centres, k, k + 6);
        }
        return is;
    }

    /** The bounds of centres in a frame. */
    int[] centres(int frame) {
        int[] copy = new int[6];
        System.arraycopy(centres, 6 * frame, copy, 0, 6);
        return copy;
    }

    /** Begins with bounds that are known. */
    void start(int[] bounds) {
        System.arraycopy(bounds, 0, centres, 0, 6);
    }

    private void swap(int a, int b) {
        exchange(items, a, b);
        for (int k = 0; k < 6; k++) {
            exchange(records, 6 * a + k, 6 * b + k);
        }
    }

    private static void exchange(int[] values, int a, int b) {
        int value = values[a];
        values[a] = values[b];
        values[b] = value;
    }

    private void growCentres(int frame, int i) {
        for (int axis = 0; axis < 3; axis++) {
            int centre = records[6 * i + axis] + records[6 * i + axis + 3];
            centres[frame + axis] = Math.min(centres[frame + axis], centre);
            centres[frame + 3 + axis] = Math.max(centres[frame + 3 + axis], centre);
        }
    }

    /** Half the surface of a box; 0 if it is empty. */
    private static double halfArea(int[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }

    /** Nothing lies within: an extent of −1. */
    private static void empty(int[] boxes, int at) {
        for (int k = 0; k < 3; k++) {
            boxes[at + k] = Integer.MAX_VALUE;
            boxes[at + k + 3] = -1;
        }
    }

    private static void grow(int[] boxes, int at, int[] by, int from) {
        grow(boxes, at, by[from], by[from + 1], by[from + 2], by[from + 3], by[from + 4], by[from + 5]);
    }

    private static void grow(int[] boxes, int at, int minX, int minY, int minZ, int maxX, int maxY, int maxZ) {
        boxes[at] = Math.min(boxes[at], minX);
        boxes[at + 1] = Math.min(boxes[at + 1], minY);
        boxes[at + 2] = Math.min(boxes[at + 2], minZ);
        boxes[at + 3] = Math.max(boxes[at + 3], maxX);
        boxes[at + 4] = Math.max(boxes[at + 4], maxY);
        boxes[at + 5] = Math.max(boxes[at + 5], maxZ);
    }
}
