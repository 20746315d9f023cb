package cz.paprsek.render.buffer;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** What each cell of a light's grid shows. Immutable. */
final class LightCells {
    /** So many bodies between two questions whether to stop. */
    static final int BATCH = 1024;
    /** More entries are too many: then many bodies lie behind each other. */
    private static final int MOST = 3 << 19;
    /** So many cells looked at, also where a body is hidden, take too long. */
    private static final long MOST_LOOKED_AT = 1 << 23;
    /** So many between two questions whether to stop. */
    private static final long SOME_LOOKED_AT = 1 << 16;

    /** By cell, and one more: where its bodies begin among the entries. */
    final int[] starts;
    /** Two numbers each, the nearest to the light first: which body, and up to where from the light nothing of it is, as the bits of a float. */
    final int[] entries;

    private LightCells(int[] starts, int[] entries) {
        this.starts = starts;
        this.entries = entries;
    }

    /** Lays bodies over the cells, those near to the light first, but for where one is hidden by a ball nearer to the light. Empty if there are too many in them, or if it is told to stop. */
    static Optional<LightCells> of(LightOutlines outlines, LightGrid grid, BooleanSupplier stop) {
        int[] order = outlines.nearestFirst();
        float[] behind = new float[grid.size * grid.size];
        Arrays.fill(behind, Float.POSITIVE_INFINITY);
        int[] starts = new int[behind.length + 1];
        int[] cells = new int[behind.length];
        int[] bodies = new int[behind.length];
        int count = 0;
        double half = grid.halfDiagonal();
        long lookedAt = 0;
        long untilAsked = 0;
        for (int k : order) {
            float near = outlines.near(k);
            float hides = outlines.take(k, half);
            int last = grid.lastRow(outlines.edge(k, 3));
            for (int row = grid.firstRow(outlines.edge(k, 1)); row <= last; row++) {
                int first = grid.firstColumn(outlines.edge(k, 0));
                int end = grid.lastColumn(outlines.edge(k, 2));
                if (lookedAt >= untilAsked) {
                    if (lookedAt > MOST_LOOKED_AT || stop.getAsBoolean()) {
                        return Optional.empty();
                    }
                    untilAsked = lookedAt + SOME_LOOKED_AT;
                }
                lookedAt += end - first + 1;
                for (int column = first; column <= end; column++) {
                    int cell = row * grid.size + column;
                    double u = grid.middleU(column);
                    double v = grid.middleV(row);
                    if (near > behind[cell] || !outlines.mayBeIn(u, v)) {
                        continue;
                    }
                    if (hides < behind[cell] && outlines.fills(u, v)) {
                        behind[cell] = hides;
                    }
                    if (count == cells.length) {
                        if (count >= MOST) {
                            return Optional.empty();
                        }
                        cells = Arrays.copyOf(cells, 2 * count);
                        bodies = Arrays.copyOf(bodies, 2 * count);
                    }
                    cells[count] = cell;
                    bodies[count++] = k;
                    starts[cell + 1]++;
                }
            }
        }
        return Optional.of(sorted(outlines, starts, cells, bodies, count));
    }

    /** By cell, and within a cell as they came. */
    private static LightCells sorted(LightOutlines outlines, int[] starts, int[] cells, int[] bodies, int count) {
        for (int cell = 1; cell < starts.length; cell++) {
            starts[cell] += starts[cell - 1];
        }
        int[] next = starts.clone();
        int[] entries = new int[2 * count];
        for (int i = 0; i < count; i++) {
            int at = 2 * next[cells[i]]++;
            entries[at] = outlines.body(bodies[i]);
            entries[at + 1] = Float.floatToRawIntBits(outlines.near(bodies[i]));
        }
        return new LightCells(starts, entries);
    }
}
