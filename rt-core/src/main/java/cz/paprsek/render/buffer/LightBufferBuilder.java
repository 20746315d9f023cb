package cz.paprsek.render.buffer;

import cz.paprsek.math.Bounds;
import cz.paprsek.shape.placed.Balls;
import cz.paprsek.shape.placed.Surface;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/** Makes a {@link LightBuffer}, where that is worth it. */
final class LightBufferBuilder {
    /** So many bodies that are too large for a grid are still asked one by one. */
    private static final int MOST_LARGE = 8;
    /** A body is too large whose diagonal is longer than so much of that of all, or than its way from the light. */
    private static final double LARGE = 0.5;
    /** How far from the middle of the bodies the light is at least, in radii of the ball around them all. */
    private static final double OUTSIDE = 1.05;
    /** With larger numbers nothing is begun. */
    private static final double HUGE = 1e15;
    private static final int LEAST_ROWS = 128;
    private static final int MOST_ROWS = 512;

    private final Surface[] surfaces;
    private final Balls balls;
    private final boolean[] opaque;

    LightBufferBuilder(Surface[] surfaces, Balls balls, boolean[] opaque) {
        this.surfaces = surfaces;
        this.balls = balls;
        this.opaque = opaque;
    }

    /** Empty if it would not be worth it, or if it is told to stop. */
    Optional<LightBuffer> build(LightPlace light, BooleanSupplier stop) {
        Bounds all = around(IntStream.range(0, surfaces.length).toArray());
        if (!(all.magnitude() < HUGE && light.at().length() < HUGE)) {
            return Optional.empty();
        }
        double most = LARGE * LightView.length(all);
        int[] large = IntStream.range(0, surfaces.length).filter(i -> isLarge(surfaces[i].bounds(), light, most)).limit(MOST_LARGE + 1).toArray();
        int[] small = IntStream.range(0, surfaces.length).filter(i -> !isLarge(surfaces[i].bounds(), light, most)).toArray();
        Bounds box = around(small);
        double radius = LightView.length(box) / 2;
        double nearest = light.isFar() ? 1 : box.isEmpty() ? 0 : box.middle().minus(light.at()).length() - radius;
        if (box.isEmpty() || large.length > MOST_LARGE || !((radius > 0 && nearest > (OUTSIDE - 1) * radius) || light.isFar())) {
            return Optional.empty();
        }
        LightView view = new LightView(light, box);
        LightOutlines outlines = new LightOutlines(view, surfaces, balls, opaque, small);
        LightGrid grid = outlines.grid(rows(small.length), nearest);
        if (!(box.magnitude() < grid.farthest && light.at().length() < grid.farthest)) {
            return Optional.empty();
        }
        return LightCells.of(outlines, grid, stop).map(cells -> new LightBuffer(surfaces, balls, opaque, view, grid, cells, large));
    }

    private Bounds around(int[] some) {
        Bounds around = Bounds.EMPTY;
        for (int i : some) {
            around = around.union(surfaces[i].bounds());
        }
        return around;
    }

    /** As measured: so that a cell of many shows a body or two. */
    private static int rows(int bodies) {
        return Math.max(LEAST_ROWS, Math.min(MOST_ROWS, 2 * Integer.highestOneBit((int) Math.sqrt(bodies))));
    }

    private static boolean isLarge(Bounds box, LightPlace light, double most) {
        double length = LightView.length(box);
        return length > most || (!light.isFar() && length > box.middle().minus(light.at()).length());
    }
}
