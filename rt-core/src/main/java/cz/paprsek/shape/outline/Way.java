package cz.paprsek.shape.outline;

import cz.paprsek.math.Require;
import java.util.List;

/** A curve in the plane, open or closed, by how far along it one is: as many units of length for each share of it, whatever its pieces are. */
public final class Way {
    /** Steps of a piece, within which its length is summed up by Gauss's rule. */
    private static final int STEPS = 32;
    private static final int ROUNDS = 4;
    /** Where Gauss and Legendre look within −1 to 1, and how much each counts. */
    private static final double[] AT = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
    private static final double[] COUNTS = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};

    private final Piece[] pieces;
    private final boolean[] isReversed;
    /** How far along each step begins, and the last one ends. */
    private final double[] lengths;
    private final boolean isClosed;

    private Way(List<Piece> of) {
        pieces = of.toArray(Piece[]::new);
        isReversed = new boolean[pieces.length];
        lengths = new double[pieces.length * STEPS + 1];
        double x = pieces[0].x0;
        double y = pieces[0].y0;
        if (pieces.length > 1 && !begins(pieces[1], pieces[0].x1, pieces[0].y1)) {
            x = pieces[0].x1;
            y = pieces[0].y1;
        }
        double startX = x;
        double startY = y;
        for (int i = 0; i < pieces.length; i++) {
            isReversed[i] = pieces[i].x0 != x || pieces[i].y0 != y;
            x = isReversed[i] ? pieces[i].x0 : pieces[i].x1;
            y = isReversed[i] ? pieces[i].y0 : pieces[i].y1;
            for (int j = 0; j < STEPS; j++) {
                lengths[i * STEPS + j + 1] = lengths[i * STEPS + j] + length(i, (double) j / STEPS, (j + 1.0) / STEPS);
            }
        }
        isClosed = x == startX && y == startY;
    }

    private static boolean begins(Piece piece, double x, double y) {
        return (piece.x0 == x && piece.y0 == y) || (piece.x1 == x && piece.y1 == y);
    }

    /**
     * Reads one.
     *
     * @param what has it, for messages: {@code animate}
     * @param path as SVG has it: one curve, which may be open
     * @throws IllegalArgumentException with one sentence if it is none
     */
    public static Way of(String what, String path) {
        List<List<Piece>> found = new PathReader(what, path).open();
        Require.that(found.size() == 1, what + " path must be one curve, but " + (found.isEmpty() ? "leads nowhere" : "has " + found.size()));
        return new Way(found.get(0));
    }

    /** How long it is. */
    public double length() {
        return lengths[lengths.length - 1];
    }

    /**
     * Where one is after a share of the whole length, and which way it goes there.
     *
     * @param share 0 at the beginning, 1 at the end; beyond that it stays there or, if it is closed, goes around again
     * @return x, y, and the direction of length 1 there, x and y
     */
    public double[] at(double share) {
        double part = isClosed && (share < 0 || share > 1) ? share - Math.floor(share) : Math.max(0, Math.min(1, share));
        double far = part * length();
        int step = 0;
        while (step < lengths.length - 2 && lengths[step + 1] <= far) {
            step++;
        }
        int piece = step / STEPS;
        double low = (double) (step % STEPS) / STEPS;
        double within = far - lengths[step];
        double u = low + within / (lengths[step + 1] - lengths[step]) / STEPS;
        for (int i = 0; i < ROUNDS; i++) {
            double speed = speed(piece, u);
            u = speed > 0 ? Math.max(0, Math.min(1, u + (within - length(piece, low, u)) / speed)) : u;
        }
        double own = isReversed[piece] ? 1 - u : u;
        double speed = speed(piece, u);
        double sign = (isReversed[piece] ? -1 : 1) / (speed > 0 ? speed : 1);
        return new double[] {pieces[piece].x(own), pieces[piece].y(own), sign * pieces[piece].dx(own), sign * pieces[piece].dy(own)};
    }

    private double speed(int piece, double u) {
        double own = isReversed[piece] ? 1 - u : u;
        double dx = pieces[piece].dx(own);
        double dy = pieces[piece].dy(own);
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** From one u to a larger one of the same step. */
    private double length(int piece, double from, double to) {
        double sum = 0;
        for (int i = 0; i < AT.length; i++) {
            sum += COUNTS[i] * speed(piece, (from + to) / 2 + (to - from) / 2 * AT[i]);
        }
        return sum * (to - from) / 2;
    }
}
