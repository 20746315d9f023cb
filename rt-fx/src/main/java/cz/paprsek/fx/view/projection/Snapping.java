package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.edit.Rounds;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;

/** Draws what is moved to the grid, and to the sides and middles of other objects, which come first. */
final class Snapping {
    /** How near it must come, pixels. */
    private static final double REACH = 6;
    /** What touches a side is in line with it, scene units. */
    private static final double SAME = 1e-6;

    /** Sides and middles of others along u and along v, sorted. */
    private final double[] us;
    private final double[] vs;

    /** @param others none of them empty */
    Snapping(List<Box> others) {
        us = sorted(others, Box::minU, Box::centreU, Box::maxU);
        vs = sorted(others, Box::minV, Box::centreV, Box::maxV);
    }

    @SafeVarargs
    private static double[] sorted(List<Box> boxes, ToDoubleFunction<Box>... places) {
        double[] all = new double[boxes.size() * places.length];
        int i = 0;
        for (Box box : boxes) {
            for (ToDoubleFunction<Box> place : places) {
                all[i++] = place.applyAsDouble(box);
            }
        }
        Arrays.sort(all);
        return all;
    }

    /**
     * A movement along one axis.
     *
     * @param by how far
     * @param guide where what is moved is in line with another object; NaN if it is not
     */
    record Move(double by, double guide) {
        /**
         * How near something else must be to count for more.
         *
         * @param hand how far the mouse has gone
         */
        double reach(double hand, Viewport view) {
            return Double.isNaN(guide) ? REACH / view.scale() : Math.abs(by - hand) - SAME;
        }
    }

    Move alongU(Box box, double by, double reference, Viewport view) {
        return move(us, new double[] {box.minU(), box.centreU(), box.maxU()}, by, reference, view);
    }

    Move alongV(Box box, double by, double reference, Viewport view) {
        return move(vs, new double[] {box.minV(), box.centreV(), box.maxV()}, by, reference, view);
    }

    private static Move move(double[] targets, double[] own, double by, double reference, Viewport view) {
        double reach = REACH / view.scale();
        double best = Double.NaN;
        double guide = Double.NaN;
        for (double place : own) {
            OptionalDouble near = nearest(targets, place + by);
            if (near.isPresent() && Math.abs(near.getAsDouble() - place - by) <= reach) {
                reach = Math.abs(near.getAsDouble() - place - by);
                guide = near.getAsDouble();
                best = guide - place;
            }
        }
        return Double.isNaN(best) ? new Move(Rounds.toGrid(reference + by, Rounds.step(view.scale())) - reference, Double.NaN) : new Move(best, guide);
    }

    private static OptionalDouble nearest(double[] sorted, double value) {
        if (sorted.length == 0) {
            return OptionalDouble.empty();
        }
        int i = Arrays.binarySearch(sorted, value);
        if (i >= 0) {
            return OptionalDouble.of(value);
        }
        int above = Math.min(-i - 1, sorted.length - 1);
        int below = Math.max(above - 1, 0);
        return OptionalDouble.of(value - sorted[below] < sorted[above] - value ? sorted[below] : sorted[above]);
    }
}
