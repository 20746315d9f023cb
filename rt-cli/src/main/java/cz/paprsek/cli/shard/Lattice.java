package cz.paprsek.cli.shard;

/**
 * Tells of each tile of a picture which of so many lattices it is on: in each column and each row they take turns, and the points of each are as far from each other as they can be then.
 * What takes long in a picture lies together, or in rows or columns: each lattice gets its share of that.
 *
 * @source Korobov, The approximate computation of multiple integrals, Doklady Akademii Nauk SSSR 124, 1959: lattices of one generator
 */
final class Lattice {
    private final int count;
    /** By how many columns each is moved from one row to the next, and back. */
    private final long step;

    /**
     * Finds the step.
     *
     * @param tiles if there are no more of them than lattices, it does not matter which
     */
    Lattice(int count, int tiles) {
        this.count = count;
        this.step = count < tiles ? step(count) : 1;
    }

    /** The step with which the nearest two points of a lattice are farthest from each other, the smallest of those; those that leave lattices out in a column are none. */
    private static long step(int count) {
        long best = 1;
        long farthest = 0;
        for (long step = 1; step <= count / 2; step++) {
            long nearest = nearest(step, count);
            if (nearest > farthest) {
                farthest = nearest;
                best = step;
            }
        }
        return best;
    }

    /**
     * The square of the distance of the nearest two points; 0 if the step and the number of lattices have a common divisor.
     *
     * @source Lagrange, Recherches d'arithmétique, 1773: the shortest vector of a lattice in the plane
     */
    private static long nearest(long step, long count) {
        long ax = count;
        long ay = 0;
        long bx = count - step;
        long by = 1;
        long divisor = count;
        for (long rest = step; rest != 0; ) {
            long next = divisor % rest;
            divisor = rest;
            rest = next;
        }
        if (divisor > 1) {
            return 0;
        }
        while (true) {
            if (ax * ax + ay * ay < bx * bx + by * by) {
                long x = ax;
                long y = ay;
                ax = bx;
                ay = by;
                bx = x;
                by = y;
            }
            long times = Math.round((double) (ax * bx + ay * by) / (bx * bx + by * by));
            if (times == 0) {
                return bx * bx + by * by;
            }
            ax -= times * bx;
            ay -= times * by;
        }
    }

    /**
     * The place of each tile in a row in which the tiles of each lattice stand together, in the order in which they are given.
     *
     * @param columns of each tile
     * @param rows likewise
     */
    int[] places(int[] columns, int[] rows) {
        int[] next = new int[count + 1];
        for (int i = 0; i < columns.length; i++) {
            next[1 + lattice(columns[i], rows[i])]++;
        }
        for (int i = 0; i < count; i++) {
            next[i + 1] += next[i];
        }
        int[] places = new int[columns.length];
        for (int i = 0; i < columns.length; i++) {
            places[i] = next[lattice(columns[i], rows[i])]++;
        }
        return places;
    }

    private int lattice(int column, int row) {
        return (int) ((column + step * row) % count);
    }
}
