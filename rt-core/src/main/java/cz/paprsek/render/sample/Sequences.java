package cz.paprsek.render.sample;

/**
 * Scratch of one worker: what is the same for the samples of a pixel that are of one sequence, by dimension. They follow each other, so it is found once
 * for all of them.
 */
final class Sequences {
    private static final int LOG = 7;
    private static final int WIDTH = 8;
    /** Spreads dimensions over the entries: 2³² times the golden ratio. */
    private static final int SPREAD = 0x9E37_79B1;

    /** Of each entry the dimension and the pixel it is of, then place, order and key. */
    private final int[] entries = new int[WIDTH << LOG];
    private int at;

    Sequences() {
        // Dimension 0 belongs to the first entry: so none is thought to be known.
        entries[0] = 1;
    }

    /** Turns to a dimension of a pixel; whether it is known. */
    boolean find(int dimension, int pixel) {
        at = ((dimension * SPREAD) >>> (Integer.SIZE - LOG)) * WIDTH;
        return entries[at] == dimension && entries[at + 1] == pixel;
    }

    /** Keeps what is to be known of the dimension that was turned to. */
    void keep(int dimension, int pixel, int place, int order, int key) {
        entries[at] = dimension;
        entries[at + 1] = pixel;
        entries[at + 2] = place;
        entries[at + 3] = order;
        entries[at + 4] = key;
    }

    int place() {
        return entries[at + 2];
    }

    int order() {
        return entries[at + 3];
    }

    int key() {
        return entries[at + 4];
    }
}
