package cz.paprsek.render.buffer;

import cz.paprsek.math.Bounds;
import cz.paprsek.shape.placed.Balls;
import cz.paprsek.shape.placed.Surface;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.BooleanSupplier;

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
        Bounds[] boxes = new Bounds[surfaces.length];
        Bounds all = Bounds.EMPTY;
        for (int i = 0; i < boxes.length; i++) {
            if (i % LightCells.BATCH == 0 && stop.getAsBoolean()) {
                return Optional.empty();
            }
            boxes[i] = surfaces[i].bounds();
            all = all.union(boxes[i]);
        }
        if (!(all.magnitude() < HUGE && light.at().length() < HUGE)) {
            return Optional.empty();
        }
        double most = LARGE * LightView.length(all);
        int[] small = new int[boxes.length];
        int[] large = new int[MOST_LARGE];
        int smalls = 0;
        int larges = 0;
        Bounds box = Bounds.EMPTY;
        for (int i = 0; i < boxes.length; i++) {
            if (!isLarge(boxes[i], light, most)) {
                small[smalls++] = i;
                box = box.union(boxes[i]);
            } else if (larges < MOST_LARGE) {
                large[larges++] = i;
            } else {
                return Optional.empty();
            }
        }
        double radius = LightView.length(box) / 2;
        double nearest = light.isFar() ? 1 : box.isEmpty() ? 0 : box.middle().minus(light.at()).length() - radius;
        if (box.isEmpty() || !((radius > 0 && nearest > (OUTSIDE - 1) * radius) || light.isFar())) {
            return Optional.empty();
        }
        LightView view = new LightView(light, box);
        LightOutlines outlines = new LightOutlines(view, surfaces, balls, opaque, Arrays.copyOf(small, smalls));
        if (!outlines.find(boxes, stop)) {
            return Optional.empty();
        }
        LightGrid grid = outlines.grid(rows(smalls), nearest);
        if (!(box.magnitude() < grid.farthest && light.at().length() < grid.farthest)) {
            return Optional.empty();
        }
        int[] asked = Arrays.copyOf(large, larges);
        return LightCells.of(outlines, grid, stop).map(cells -> new LightBuffer(surfaces, balls, opaque, view, grid, cells, asked));
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
