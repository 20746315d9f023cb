package cz.paprsek.shape.height;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * Heights at the points of a grid, row by row, and two flat triangles in each of its cells: a cell is cut from its corner in the lower column and row to
 * the opposite one. Immutable.
 *
 * <p>Besides, the least and the greatest height of blocks of 2 × 2 cells, of 4 × 4, and so on: rays pass over what lies below them in large steps.
 */
final class Heights {
    private static final int MOST = 1 << 26;

    final int columns;
    final int rows;
    final double unit;
    final float[] steps;
    /** Of blocks 2ⁱ⁺¹ cells wide, row by row, their least and greatest height. */
    final float[][] least;
    final float[][] greatest;
    private final float most;

    /**
     * A grid.
     *
     * @param columns how many points a row has: 2 at least
     * @param rows how many rows there are: 2 at least; together at most {@value #MOST} points
     * @param steps the heights, finite and 0 or above, in units of their own; a copy is made
     * @param unit what one of those is, so that heights of whole numbers are exact; above 0
     */
    Heights(int columns, int rows, float[] steps, double unit) {
        this(columns, rows, unit, steps.clone());
    }

    /** As the other one, with steps that nobody else has. */
    private Heights(int columns, int rows, double unit, float[] steps) {
        checkSize(columns, rows);
        Require.that(steps.length == columns * rows, "there must be a height for each of " + columns + " × " + rows + " points, but there are " + steps.length);
        this.columns = columns;
        this.rows = rows;
        this.unit = Require.positive("unit of heights", unit);
        this.steps = steps;
        float high = 0;
        for (float step : steps) {
            Require.that(step >= 0 && step <= Float.MAX_VALUE, "heights must be finite numbers, 0 or above, but one is " + step);
            high = Math.max(high, step);
        }
        most = high;
        int levels = 32 - Integer.numberOfLeadingZeros(Math.max(columns, rows) - 2);
        least = new float[levels][];
        greatest = new float[levels][];
        for (int level = 0; level < levels; level++) {
            gather(level);
        }
    }

    /**
     * A grid.
     *
     * @param columns as above
     * @param step the heights, in units of their own
     */
    static Heights of(int columns, int rows, HeightField.Steps step, double unit) {
        checkSize(columns, rows);
        float[] steps = new float[columns * rows];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                steps[row * columns + column] = step.at(column, row);
            }
        }
        return new Heights(columns, rows, unit, steps);
    }

    private static void checkSize(int columns, int rows) {
        Require.that(columns >= 2 && rows >= 2, "heights must be given at 2 × 2 points or more, but are at " + columns + " × " + rows);
        Require.that((long) columns * rows <= MOST, "heights must be given at " + MOST + " points or fewer, but are at " + columns + " × " + rows);
    }

    /** How many blocks of a level stand in a row. */
    int across(int level) {
        return ((columns - 2) >> (level + 1)) + 1;
    }

    private int down(int level) {
        return ((rows - 2) >> (level + 1)) + 1;
    }

    private void gather(int level) {
        int across = across(level);
        int down = down(level);
        least[level] = new float[across * down];
        greatest[level] = new float[across * down];
        for (int z = 0; z < down; z++) {
            for (int x = 0; x < across; x++) {
                float low = Float.MAX_VALUE;
                float high = 0;
                if (level == 0) {
                    for (int row = 2 * z; row <= Math.min(2 * z + 2, rows - 1); row++) {
                        for (int column = 2 * x; column <= Math.min(2 * x + 2, columns - 1); column++) {
                            low = Math.min(low, steps[row * columns + column]);
                            high = Math.max(high, steps[row * columns + column]);
                        }
                    }
                } else {
                    for (int row = 2 * z; row <= Math.min(2 * z + 1, down(level - 1) - 1); row++) {
                        for (int column = 2 * x; column <= Math.min(2 * x + 1, across(level - 1) - 1); column++) {
                            low = Math.min(low, least[level - 1][row * across(level - 1) + column]);
                            high = Math.max(high, greatest[level - 1][row * across(level - 1) + column]);
                        }
                    }
                }
                least[level][z * across + x] = low;
                greatest[level][z * across + x] = high;
            }
        }
    }

    int columns() {
        return columns;
    }

    int rows() {
        return rows;
    }

    /** The height at a point of the grid. */
    double at(int column, int row) {
        return unit * steps[row * columns + column];
    }

    /** The greatest of all. */
    double greatest() {
        return unit * most;
    }

    /** From a grid whose cells are 1 wide to a field of the given size, which stands on y = 0 with its middle over the origin; the first row lies at −z. */
    private Affine fromGrid(Vec3 size) {
        return Affine.scalingAndMoving(new Vec3(size.x() / (columns - 1), size.y() * unit, size.z() / (rows - 1)), new Vec3(-size.x() / 2, 0, -size.z() / 2));
    }

    /** The box around a field of the given size. */
    Bounds bounds(Vec3 size) {
        return new Bounds(-size.x() / 2, 0, -size.z() / 2, size.x() / 2, size.y() * greatest(), size.z() / 2);
    }

    /**
     * Lines over the relief, along both sides of the grid, those at its rims among them.
     *
     * @param lines how many there are along each side, at most
     * @param pieces how many straight pieces each has, at most
     */
    List<List<Vec3>> lines(Vec3 size, int lines, int pieces) {
        Affine fromGrid = fromGrid(size);
        List<List<Vec3>> drawn = new ArrayList<>();
        for (int row : chosen(rows, lines)) {
            drawn.add(Arrays.stream(chosen(columns, pieces)).mapToObj(column -> fromGrid.point(new Vec3(column, steps[row * columns + column], row))).toList());
        }
        for (int column : chosen(columns, lines)) {
            drawn.add(Arrays.stream(chosen(rows, pieces)).mapToObj(row -> fromGrid.point(new Vec3(column, steps[row * columns + column], row))).toList());
        }
        return drawn;
    }

    /** So many of the numbers below a count, the first and the last among them. */
    private static int[] chosen(int count, int most) {
        int chosen = Math.max(2, Math.min(count, most));
        int[] numbers = new int[chosen];
        for (int i = 0; i < chosen; i++) {
            numbers[i] = (int) ((long) i * (count - 1) / (chosen - 1));
        }
        return numbers;
    }

    /** A field of the given size, ready for rays. */
    Volume place(Vec3 size, boolean isSmooth, Affine toWorld, Parts parts) {
        return parts.add(part -> new PlacedHeights(part, toWorld.after(fromGrid(size)), this, isSmooth));
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof Heights o && columns == o.columns && rows == o.rows && unit == o.unit && Arrays.equals(steps, o.steps);
    }

    @Override
    public int hashCode() {
        return Objects.hash(columns, rows, unit, Arrays.hashCode(steps));
    }

    @Override
    public String toString() {
        return columns + " × " + rows + " heights";
    }
}
