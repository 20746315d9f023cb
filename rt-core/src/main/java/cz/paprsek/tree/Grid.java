package cz.paprsek.tree;

/** ItemBoxes in double precision, and the whole numbers that stand for them in {@link Bins}: as many steps along the longest side of all as there are. */
final class Grid {
    private final double[] whole;
    private final double scale;

    /** @param whole a box that holds all others */
    Grid(double[] whole) {
        this.whole = whole.clone();
        double side = Math.max(whole[3] - whole[0], Math.max(whole[4] - whole[1], whole[5] - whole[2]));
        scale = side > 0 ? Math.min(Bins.SIDE / side, Double.MAX_VALUE) : 0;
    }

    /** Writes what stands for a box. */
    void put(double[] box, int from, int[] records, int to) {
        for (int k = 0; k < 6; k++) {
            records[to + k] = (int) ((box[from + k] - whole[k % 3]) * scale);
        }
    }

    /** Makes a box that holds nothing. */
    static void empty(double[] boxes, int at) {
        for (int k = 0; k < 3; k++) {
            boxes[at + k] = Double.POSITIVE_INFINITY;
            boxes[at + k + 3] = Double.NEGATIVE_INFINITY;
        }
    }

    /** Makes a box hold another one. Not by Math.min: a comparison that mostly goes one way costs far less. */
    static void grow(double[] boxes, int at, double[] by, int from) {
        for (int k = 0; k < 3; k++) {
            if (by[from + k] < boxes[at + k]) {
                boxes[at + k] = by[from + k];
            }
            if (by[from + k + 3] > boxes[at + k + 3]) {
                boxes[at + k + 3] = by[from + k + 3];
            }
        }
    }
}
