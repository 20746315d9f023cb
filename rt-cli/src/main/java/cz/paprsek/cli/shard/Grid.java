package cz.paprsek.cli.shard;

import cz.paprsek.render.Tile;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/** The cells of a picture, squares but at its right and lower edge: of whole ones every part consists, so that it can be told which are there. */
final class Grid {
    /** Pixels along each side of a cell. */
    static final int SIDE = 32;

    private final Tile region;
    private final int columns;
    private final BitSet covered = new BitSet();

    /** Nothing is there yet. */
    Grid(Tile region) {
        this.region = region;
        columns = cells(region.width(), SIDE);
    }

    Grid copy() {
        Grid same = new Grid(region);
        same.covered.or(covered);
        return same;
    }

    /** What is there in both. */
    Grid and(Grid other) {
        Grid both = copy();
        both.covered.and(other.covered);
        return both;
    }

    static int cells(int pixels, int side) {
        return (pixels + side - 1) / side;
    }

    /** Whether a tile consists of whole cells of a picture. */
    static boolean has(Tile region, Tile tile) {
        return has(tile.x() - region.x(), tile.width(), region.width()) && has(tile.y() - region.y(), tile.height(), region.height());
    }

    private static boolean has(int from, int length, int all) {
        return from >= 0 && from % SIDE == 0 && length <= all - from && (length % SIDE == 0 || length == all - from);
    }

    /**
     * The tiles of so many pixels along each side, and less at the edges; in an order in which each is a neighbour of the one before, but where the way leaves the picture.
     *
     * @source Hilbert, Über die stetige Abbildung einer Linie auf ein Flächenstück, 1891
     */
    static List<Tile> tiles(Tile region, int side) {
        int columns = cells(region.width(), side);
        int rows = cells(region.height(), side);
        List<Tile> tiles = new ArrayList<>(columns * rows);
        int corner = Integer.highestOneBit(2 * Math.max(columns, rows) - 1);
        for (int i = 0; i < corner * corner; i++) {
            int column = 0;
            int row = 0;
            int rest = i;
            for (int half = 1; half < corner; half *= 2) {
                int right = rest >> 1 & 1;
                int down = (rest ^ right) & 1;
                if (down == 0) {
                    int turned = right == 1 ? half - 1 - row : row;
                    row = right == 1 ? half - 1 - column : column;
                    column = turned;
                }
                column += half * right;
                row += half * down;
                rest >>= 2;
            }
            if (column < columns && row < rows) {
                tiles.add(new Tile(region.x() + column * side, region.y() + row * side, Math.min(side, region.width() - column * side), Math.min(side, region.height() - row * side)));
            }
        }
        return tiles;
    }

    /** A part is there. */
    void cover(Tile tile) {
        for (int row = row(tile); row < row(tile) + cells(tile.height(), SIDE); row++) {
            covered.set(row * columns + column(tile), row * columns + column(tile) + cells(tile.width(), SIDE));
        }
    }

    /** Whether all of a tile is there. */
    boolean covers(Tile tile) {
        return missing(tile) == 0;
    }

    /** Whether some of a tile is there. */
    boolean touches(Tile tile) {
        return missing(tile) < cells(tile.width(), SIDE) * cells(tile.height(), SIDE);
    }

    /** How many cells of a tile are not there. */
    int missing(Tile tile) {
        int missing = 0;
        for (int row = row(tile); row < row(tile) + cells(tile.height(), SIDE); row++) {
            int from = row * columns + column(tile);
            int width = cells(tile.width(), SIDE);
            missing += width - covered.get(from, from + width).cardinality();
        }
        return missing;
    }

    private int column(Tile tile) {
        return (tile.x() - region.x()) / SIDE;
    }

    private int row(Tile tile) {
        return (tile.y() - region.y()) / SIDE;
    }
}
