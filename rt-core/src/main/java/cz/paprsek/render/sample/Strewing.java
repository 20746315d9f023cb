package cz.paprsek.render.sample;

import cz.paprsek.scene.RenderSettings.PixelFilter;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;

/** A pixel filter along one axis: turns evenly distributed numbers into places as dense as the filter is high, below nothing or above. Immutable. */
abstract class Strewing {
    /** The pixel's centre. */
    private static final double CENTRE = 0.5;

    static Strewing of(PixelFilter filter) {
        return switch (filter) {
            case BOX -> new Box();
            case TENT -> new Tent();
            case GAUSS -> new Curve(2, false, x -> StrictMath.exp(-2 * x * x));
            case MITCHELL -> new Curve(2, true, Strewing::mitchell);
        };
    }

    /** The place of a number from 0 to 1, in pixels from the pixel's edge. */
    abstract double place(double u);

    /** Whether the filter is below nothing at a place. */
    boolean isNegative(double place) {
        return false;
    }

    /** The area between filter and axis, what is below counted as if it were above; that of the filter itself is 1. */
    double mass() {
        return 1;
    }

    /** How many pixels beyond the pixel itself, rounded up, the filter reaches to each side. */
    abstract int reach();

    /** With B = C = ⅓. */
    private static double mitchell(double offset) {
        double x = Math.abs(offset);
        return (x < 1 ? (7 * x - 12) * x * x + 16.0 / 3 : ((-7.0 / 3 * x + 12) * x - 20) * x + 32.0 / 3) / 6;
    }

    private static final class Box extends Strewing {
        @Override
        double place(double u) {
            return u;
        }

        @Override
        int reach() {
            return 0;
        }
    }

    private static final class Tent extends Strewing {
        @Override
        double place(double u) {
            return u < CENTRE ? CENTRE - (1 - Math.sqrt(2 * u)) : CENTRE + (1 - Math.sqrt(2 * (1 - u)));
        }

        @Override
        int reach() {
            return 1;
        }
    }

    /** Any symmetric curve, by a table of the area up to each of many places. */
    private static final class Curve extends Strewing {
        private static final int CELLS = 1024;

        private final double width;
        private final boolean goesBelow;
        private final DoubleUnaryOperator height;
        /** Of one half, from the centre outwards: the share of the area up to the end of each cell. */
        private final double[] areas = new double[CELLS + 1];
        private final double mass;

        /** @param goesBelow whether it is below nothing anywhere: else no ray need ask */
        Curve(double width, boolean goesBelow, DoubleUnaryOperator height) {
            this.width = width;
            this.goesBelow = goesBelow;
            this.height = height;
            double above = 0;
            double all = 0;
            for (int i = 0; i < CELLS; i++) {
                double h = height.applyAsDouble((i + 0.5) * width / CELLS);
                above += h;
                all += Math.abs(h);
                areas[i + 1] = all;
            }
            for (int i = 1; i <= CELLS; i++) {
                areas[i] /= all;
            }
            mass = all / above;
        }

        @Override
        double place(double u) {
            double share = Math.abs(2 * u - 1);
            int found = Arrays.binarySearch(areas, share);
            int cell = Math.min(found >= 0 ? found : -found - 2, CELLS - 1);
            double offset = (cell + (share - areas[cell]) / (areas[cell + 1] - areas[cell])) * width / CELLS;
            return u < CENTRE ? CENTRE - offset : CENTRE + offset;
        }

        @Override
        boolean isNegative(double place) {
            return goesBelow && height.applyAsDouble(place - CENTRE) < 0;
        }

        @Override
        double mass() {
            return mass;
        }

        @Override
        int reach() {
            return (int) Math.ceil(width - CENTRE);
        }
    }
}
