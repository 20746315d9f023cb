package cz.paprsek.tree;

import java.util.Optional;

/** A few balls side by side, all of which are asked at once which of them a line meets. Immutable. */
public abstract class Row {
    /** So many at most. */
    public static final int MOST = 8;

    /**
     * Of balls; empty if this machine asks them one by one as fast.
     *
     * @param balls of each x, y, z and the square of the radius
     */
    public static Optional<Row> of(double[] balls) {
        return balls.length > 4 * MOST ? Optional.empty() : Kernel.row(balls);
    }

    /**
     * Finds the square of half the chord of each ball, not positive if the line passes it by: with l from o to the centre and b = l·d, r² − |l − b·d|².
     *
     * @param dx of the direction of length 1
     * @param halves receives {@value #MOST} numbers
     */
    public abstract void ask(double ox, double oy, double oz, double dx, double dy, double dz, double[] halves);
}
