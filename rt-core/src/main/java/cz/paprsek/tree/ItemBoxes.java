package cz.paprsek.tree;

/** Tells the boxes of the items that go into a tree. Asked by several threads at once. */
@FunctionalInterface
public interface ItemBoxes {
    /** Writes the box of an item to an array, from a place on: its minimum x y z, its maximum x y z, all finite. */
    void put(int item, double[] to, int at);

    /** Those in an array, six numbers for each item. */
    static ItemBoxes of(double[] boxes) {
        return (item, to, at) -> System.arraycopy(boxes, 6 * item, to, at, 6);
    }
}
