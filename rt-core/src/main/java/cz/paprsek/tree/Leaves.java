package cz.paprsek.tree;

/** Who meets the items of leaves with many lines at once. */
public interface Leaves {
    /**
     * Meets the items of a leaf, those at the places from {@code first} to {@code end} − 1, unless they are of a kind that is better met by each line alone.
     *
     * @return whether they have been met
     */
    boolean take(int first, int end);

    /** Up to which t any of the lines may still meet something. */
    double reach();
}
