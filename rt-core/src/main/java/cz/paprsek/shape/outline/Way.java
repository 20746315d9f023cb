package cz.paprsek.shape.outline;

import cz.paprsek.math.Require;
import java.util.List;

/** A curve in the plane, open or closed, by how far along it one is: as many units of length for each share of it, whatever its pieces are. */
public final class Way {
    /** Steps of a piece, within which its length is summed up by Gauss's rule. */
    private static final int STEPS = 32;
    private static final int ROUNDS = 4;
    /** Below this share of the whole length for each u one stands still, as where a handle of a Bézier curve lies on its end; and how far from there a direction is looked for. */
    private static final double STILL = 1e-9;
    private static final double ASIDE = 1e-4;
    /** Where Gauss and Legendre look within −1 to 1, and how much each counts. */
    private static final double[] AT = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
    private static final double[] COUNTS = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};

    private final Piece[] pieces;
    /** How far along each step begins, and the last one ends. */
    private final double[] lengths;
    private final boolean isClosed;

    private Way(List<Piece> of) {
        pieces = of.toArray(Piece[]::new);
        lengths = new double[pieces.length * STEPS + 1];
        for (int i = 0; i < pieces.length; i++) {
            for (int j = 0; j < STEPS; j++) {
                lengths[i * STEPS + j + 1] = lengths[i * STEPS + j] + length(i, (double) j / STEPS, (j + 1.0) / STEPS);
            }
        }
        Piece first = pieces[0];
        Piece last = pieces[pieces.length - 1];
        isClosed = (first.isBackward() ? first.x1 : first.x0) == (last.isBackward() ? last.x0 : last.x1)
                && (first.isBackward() ? first.y1 : first.y0) == (last.isBackward() ? last.y0 : last.y1);
    }

    /**
     * Reads one.
     *
     * @param what has it, for messages: {@code animate}
     * @param path as SVG has it: one curve, which may be open
     * @throws IllegalArgumentException with one sentence if it is none, has no length or more than 20 000 pieces
     */
    public static Way of(String what, String path) {
        List<List<Piece>> found = new PathReader(what, path).open();
        Require.that(found.size() == 1, what + " path must be one curve, but " + (found.isEmpty() ? "leads nowhere" : "has " + found.size()));
        Require.that(found.get(0).size() <= Outline.MOST_PIECES, what + " path must have at most " + Outline.MOST_PIECES + " pieces, but has " + found.get(0).size());
        Way way = new Way(found.get(0));
        Require.that(way.length() > 0, what + " path leads nowhere: it is too short to have a length");
        return way;
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
        int step = step(far);
        int piece = step / STEPS;
        double low = (double) (step % STEPS) / STEPS;
        double within = far - lengths[step];
        double width = lengths[step + 1] - lengths[step];
        // Beside long pieces a short one may add nothing to the sum: then one is at its end.
        double u = width > 0 ? low + within / width / STEPS : low + 1.0 / STEPS;
        for (int i = 0; i < ROUNDS && width > 0; i++) {
            double speed = speed(piece, u);
            u = speed > 0 ? Math.max(0, Math.min(1, u + (within - length(piece, low, u)) / speed)) : u;
        }
        double own = own(piece, u);
        double speed = speed(piece, u);
        double sign = pieces[piece].isBackward() ? -1 : 1;
        if (speed > STILL * length()) {
            return new double[] {pieces[piece].x(own), pieces[piece].y(own), sign / speed * pieces[piece].dx(own), sign / speed * pieces[piece].dy(own)};
        }
        // Where it stands still it has no direction: that which it comes from or goes to, a little towards the middle.
        double moved = own < 0.5 ? own + ASIDE : own - ASIDE;
        double dx = pieces[piece].dx(moved);
        double dy = pieces[piece].dy(moved);
        double size = StrictMath.hypot(dx, dy);
        return new double[] {pieces[piece].x(own), pieces[piece].y(own), size > 0 ? sign * dx / size : 0, size > 0 ? sign * dy / size : 0};
    }

    /** The step in which one is so far along: the first that ends beyond that, or the last one. */
    private int step(double far) {
        int low = 0;
        int high = lengths.length - 2;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (lengths[middle + 1] <= far) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Of a piece that the path has the other way round, u from its own beginning. */
    private double own(int piece, double u) {
        return pieces[piece].isBackward() ? 1 - u : u;
    }

    private double speed(int piece, double u) {
        double own = own(piece, u);
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
