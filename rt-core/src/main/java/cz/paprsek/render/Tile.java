package cz.paprsek.render;

import cz.paprsek.math.Require;

/** A rectangle of pixels: column and row of its top left pixel, and its size. */
public record Tile(int x, int y, int width, int height) {
    public Tile {
        Require.within("x", x, 0, 1 << 16);
        Require.within("y", y, 0, 1 << 16);
        Require.within("width", width, 1, 1 << 16);
        Require.within("height", height, 1, 1 << 16);
    }
}
