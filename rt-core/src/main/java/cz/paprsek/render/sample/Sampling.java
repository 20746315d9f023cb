package cz.paprsek.render.sample;

/** Where in a pixel its rays go through: one class for each pattern. Immutable. */
public abstract class Sampling {
    private final boolean fixed;

    Sampling(boolean fixed) {
        this.fixed = fixed;
    }

    /** A regular grid of so many rays along each side of a pixel. */
    public static Sampling grid(int perSide) {
        return new Grid(perSide, false);
    }

    /** The same grid, with what is random the same in every pixel. */
    public static Sampling fixedGrid(int perSide) {
        return new Grid(perSide, true);
    }

    /** How many rays a pixel gets. */
    public abstract int rays();

    /** Where the i-th of them goes through, in pixels from the left edge of its own, 0–1. */
    public abstract double across(int i);

    /** Likewise from the top. */
    public abstract double down(int i);

    /** The worker's scratch that says what is random in the pixels. */
    public final Sampler newSampler() {
        return fixed ? Sampler.fixed(rays()) : Sampler.scrambled(rays());
    }

    /** A regular grid, row by row: a picture of n × n samples is the average of a picture n times the size. */
    private static final class Grid extends Sampling {
        private final double[] across;
        private final double[] down;

        Grid(int perSide, boolean fixed) {
            super(fixed);
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
        public int rays() {
            return across.length;
        }

        @Override
        public double across(int i) {
            return across[i];
        }

        @Override
        public double down(int i) {
            return down[i];
        }
    }
}
