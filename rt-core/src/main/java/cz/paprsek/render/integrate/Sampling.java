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
        private final int perSide;
        private final double[] middles;

        Grid(int perSide) {
            this.perSide = perSide;
            middles = new double[perSide];
            for (int i = 0; i < perSide; i++) {
                middles[i] = (i + 0.5) / perSide;
            }
        }

        @Override
        int rays() {
            return perSide * perSide;
        }

        @Override
        double across(int i) {
            return middles[i % perSide];
        }

        @Override
        double down(int i) {
            return middles[i / perSide];
        }
    }
}
