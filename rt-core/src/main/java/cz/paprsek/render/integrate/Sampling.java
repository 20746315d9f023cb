package cz.paprsek.render.integrate;

/** Where in a pixel its rays go through: one class for each pattern. Immutable. */
public abstract class Sampling {
    /** The pattern of rays along each side of a pixel. */
    public static Sampling grid(int perSide) {
        return new Grid(perSide);
    }

    /** How many rays a pixel gets. */
    abstract int rays();

    /** Where the i-th of them goes through, in pixels from the left edge of its own, 0–1. */
    abstract double across(int i);

    /** Likewise from the top. */
    abstract double down(int i);

    /** A regular grid, row by row: a picture of n × n samples is the average of a picture n times the size. */
    private static final class Grid extends Sampling {
        private final double[] across;
        private final double[] down;

        Grid(int perSide) {
            across = new double[perSide * perSide];
            down = new double[perSide * perSide];
            for (int row = 0; row < perSide; row++) {
                for (int column = 0; column < perSide; column++) {
                    across[row * perSide + column] = (column + 0.5) / perSide;
                    down[row * perSide + column] = (row + 0.5) / perSide;
                }
            }
        }

        @Override
        int rays() {
            return across.length;
        }

        @Override
        double across(int i) {
            return across[i];
        }

        @Override
        double down(int i) {
            return down[i];
        }
    }
}
