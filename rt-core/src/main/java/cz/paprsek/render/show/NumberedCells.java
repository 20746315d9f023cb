package cz.paprsek.render.show;

import cz.paprsek.material.Rgb;

/**
 * A picture to lay on surfaces, to see how it lies: ten by ten cells, each with the tenths of its u and v as two digits, redder to the right and
 * greener upwards. Beyond 0–1 it repeats.
 */
final class NumberedCells {
    /** The digits 0 to 9 in three columns and five rows, from the top left on. */
    private static final String[] DIGITS = {
        "111101101101111", "010110010010111", "111001111100111", "111001011001111", "101101111001001",
        "111100111001111", "111100111101111", "111001010010010", "111101111101111", "111101111001111"
    };
    private static final double LEFT = 0.15;
    private static final double BOTTOM = 0.2;
    private static final int COLUMNS = 7;
    private static final int ROWS = 5;

    private NumberedCells() {}

    static Rgb color(double u, double v) {
        double x = 10 * (u - Math.floor(u));
        double y = 10 * (v - Math.floor(v));
        int column = Math.min((int) x, 9);
        int row = Math.min((int) y, 9);
        double shade = (column + row) % 2 == 0 ? 1 : 0.75;
        double red = shade * (55 + 20 * x);
        double green = shade * (55 + 20 * y);
        if (isInk(column, row, x - column, y - row)) {
            return column + 2 * row > 12 ? Rgb.BLACK : Rgb.WHITE;
        }
        return new Rgb(red, green, shade * 150);
    }

    /** Whether a point of a cell, 0–1 to the right and up, lies on one of its two digits. */
    private static boolean isInk(int column, int row, double x, double y) {
        int across = (int) Math.floor((x - LEFT) / (1 - 2 * LEFT) * COLUMNS);
        int down = ROWS - 1 - (int) Math.floor((y - BOTTOM) / (1 - 2 * BOTTOM) * ROWS);
        if (across < 0 || across >= COLUMNS || across == 3 || down < 0 || down >= ROWS) {
            return false;
        }
        return DIGITS[across < 3 ? column : row].charAt(3 * down + across % 4) == '1';
    }
}
