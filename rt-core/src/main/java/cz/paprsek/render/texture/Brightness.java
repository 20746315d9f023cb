package cz.paprsek.render.texture;

import cz.paprsek.ray.Hit;

/**
 * How bright a picture of everything around, 360° × 180°, is in each of the cells of a grid, to choose directions as often as they are bright. Within a cell all
 * directions are as probable. Immutable.
 */
public final class Brightness {
    /** More columns than these tell hardly more. */
    private static final int MOST_COLUMNS = 1024;
    /** Along each side of a cell, places that are looked at of each of the picture's points. */
    private static final int PER_POINT = 2;

    private final int columns;
    private final int rows;
    /** Of the lower edge of each row, and last of the uppermost one, the sine of its height. */
    private final double[] edges;
    /** Which share of the light is below each row, and last all. */
    private final double[] below;
    /** Of each row, which share of its light is left of each cell, and last all. */
    private final double[] left;

    private Brightness(int columns, int rows) {
        this.columns = columns;
        this.rows = rows;
        edges = new double[rows + 1];
        below = new double[rows + 1];
        left = new double[rows * (columns + 1)];
        for (int i = 0; i <= rows; i++) {
            edges[i] = i == 0 ? -1 : i == rows ? 1 : StrictMath.sin(Math.PI * ((double) i / rows - 0.5));
        }
    }

    static Brightness of(Texture picture) {
        Brightness grid = new Brightness(Math.min(MOST_COLUMNS, picture.width()), Math.min(MOST_COLUMNS / 2, picture.height()));
        grid.fill(picture);
        return grid;
    }

    private void fill(Texture picture) {
        int across = PER_POINT * ((picture.width() + columns - 1) / columns);
        int up = PER_POINT * ((picture.height() + rows - 1) / rows);
        Hit hit = new Hit();
        for (int row = 0; row < rows; row++) {
            int first = row * (columns + 1);
            for (int column = 0; column < columns; column++) {
                double sum = 0;
                for (int i = 0; i < up; i++) {
                    for (int j = 0; j < across; j++) {
                        picture.bilinear((column + (j + 0.5) / across) / columns, (row + (i + 0.5) / up) / rows, hit);
                        sum += hit.red + hit.green + hit.blue;
                    }
                }
                left[first + column + 1] = left[first + column] + sum;
            }
            double all = left[first + columns];
            below[row + 1] = below[row] + all * (edges[row + 1] - edges[row]);
            divide(left, first, columns, all);
        }
        divide(below, 0, rows, below[rows]);
    }

    /** Makes sums shares of the whole. */
    private static void divide(double[] sums, int from, int count, double whole) {
        for (int i = 1; i <= count && whole > 0; i++) {
            sums[from + i] = i == count ? 1 : sums[from + i] / whole;
        }
    }

    /** Whether there is no light at all. */
    public boolean isNone() {
        return below[rows] == 0;
    }

    /** The sine of the height that a random number, 0–1, chooses. */
    public double height(double chosen) {
        int row = place(below, 0, rows, chosen);
        double height = edges[row] + (edges[row + 1] - edges[row]) * (chosen - below[row]) / (below[row + 1] - below[row]);
        // Rounded up, it would lie in the next row, which may be black.
        return Math.min(height, Math.nextDown(edges[row + 1]));
    }

    /** The u that a random number, 0–1, chooses at a height. */
    public double across(double height, double chosen) {
        int first = row(height) * (columns + 1);
        int column = place(left, first, columns, chosen);
        return (column + (chosen - left[first + column]) / (left[first + column + 1] - left[first + column])) / columns;
    }

    /** How probable a direction is, per solid angle. */
    public double density(double u, double height) {
        int row = row(height);
        int at = row * (columns + 1) + Math.min(columns - 1, (int) (u * columns));
        return (below[row + 1] - below[row]) * (left[at + 1] - left[at]) * columns / (2 * Math.PI * (edges[row + 1] - edges[row]));
    }

    private int row(double height) {
        return place(edges, 0, rows, height);
    }

    /** The last of rising numbers, of which the first is not above a value and the last is not counted, that is not above it; of several alike the last. */
    private static int place(double[] rising, int from, int count, double value) {
        int low = 0;
        int high = count;
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (rising[from + middle] <= value) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
