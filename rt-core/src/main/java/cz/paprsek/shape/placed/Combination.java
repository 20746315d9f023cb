package cz.paprsek.shape.placed;

/** How two solids make one: what is in neither is not in it, and what is in the right one alone only if what is in the left one alone is too. */
public interface Combination {
    /** Whether a point is inside the result, given whether it is inside the left and the right solid. */
    boolean inside(boolean inLeft, boolean inRight);
}
