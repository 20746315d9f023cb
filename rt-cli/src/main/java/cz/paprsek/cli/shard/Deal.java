package cz.paprsek.cli.shard;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.value.Shard;
import cz.paprsek.render.Tile;
import java.io.InterruptedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Predicate;

/**
 * How the work on a picture, or on the frames of a film, is dealt out, in parts of which each becomes a file. It depends on nothing but the picture and the
 * number of shares; that of a share takes as long as that of any other, about, as the tiles of each lie all over the picture, as far from each other as they can. Of many
 * frames everybody gets whole ones with all their passes, as each must be prepared by whoever renders something of it; of fewer frames with many passes, whole passes, to everybody as
 * many; those that are left over by tiles.
 */
final class Deal {
    /** How many parts a share has at least, if the picture is large enough: who is killed loses one of them. */
    private static final int PARTS = 256;
    private static final int LARGEST_SIDE = 512;
    /** From so many frames for each share on, they are dealt out as a whole. */
    private static final int FRAMES = 8;
    private static final double GOLDEN = 0.618033988749895;

    private final List<Tile> tiles;
    /** Of each tile, its place in a row of all that is cut into shares. */
    private final int[] places;
    private final int first;
    /** Into how many passes each frame is divided; 0 if it is not. */
    private final int passes;
    /** How many frames there are, each counted as often as it has passes. */
    private final long slices;
    private final int shards;
    /** How many of the first of them are dealt out as a whole, each to one, as many to everybody. */
    private final long whole;

    /**
     * A piece of work.
     *
     * @param frame from 1; 0 of a picture that is no film
     * @param pass from 1; 0 for all
     */
    record Piece(int frame, int pass, Tile tile) {}

    /** @param passes into how many each frame is divided; 0 if it is not */
    Deal(Tile region, Span span, int passes, int shards) {
        this.first = span.first();
        this.passes = passes;
        this.shards = shards;
        slices = (long) span.count() * Math.max(1, passes);
        whole = passes > 0 && (slices >= (long) FRAMES * shards || slices % shards == 0) ? slices - slices % shards : 0;
        int side = side(region, slices, (long) PARTS * shards);
        tiles = Grid.tiles(region, side);
        places = new Lattice(shards, tiles.size()).places(tiles.stream().mapToInt(tile -> (tile.x() - region.x()) / side).toArray(), tiles.stream().mapToInt(tile -> (tile.y() - region.y()) / side).toArray());
    }

    /** The largest side of tiles with which there are so many of them, if there can be. */
    static int side(Tile region, long slices, long wanted) {
        int side = LARGEST_SIDE;
        while (side > Grid.SIDE && (long) Grid.cells(region.width(), side) * Grid.cells(region.height(), side) * slices < wanted) {
            side -= Grid.SIDE;
        }
        return side;
    }

    /** How many parts there are. */
    long parts() {
        return (long) tiles.size() * slices;
    }

    /** What a share has to do, frame by frame. */
    List<Piece> of(Shard shard) {
        List<Piece> own = new ArrayList<>();
        for (long slice = 0; slice < slices; slice++) {
            for (int i = 0; i < tiles.size(); i++) {
                if (owner(slice, i) == shard.number()) {
                    own.add(piece(slice, i));
                }
            }
        }
        return own;
    }

    /**
     * Whose work some pieces are, in order.
     *
     * @throws InterruptedIOException if a stop is asked for: of a long film there are many pieces
     */
    List<Integer> owners(Predicate<Piece> which, Stop stop) throws InterruptedIOException {
        SortedSet<Integer> owners = new TreeSet<>();
        long slice = 0;
        while (slice < slices && owners.size() < shards) {
            if (stop.requested()) {
                throw new InterruptedIOException("interrupted");
            }
            for (int i = 0; i < tiles.size(); i++) {
                if (which.test(piece(slice, i))) {
                    owners.add(owner(slice, i));
                }
            }
            slice += areFramesWhole() && owners.contains(owner(slice, 0)) ? passesOfFrame() - slice % passesOfFrame() : 1;
        }
        return List.copyOf(owners);
    }

    private Piece piece(long slice, int tile) {
        return passes == 0 ? new Piece(first + (int) slice, 0, tiles.get(tile)) : new Piece(first + (int) (slice / passes), 1 + (int) (slice % passes), tiles.get(tile));
    }

    private boolean areFramesWhole() {
        return slices / passesOfFrame() >= (long) FRAMES * shards;
    }

    private int passesOfFrame() {
        return Math.max(1, passes);
    }

    /** Whose work a tile is. */
    private int owner(long slice, int tile) {
        if (areFramesWhole()) {
            return 1 + (int) (slice / passesOfFrame() % shards);
        }
        // Passes take as long as each other.
        if (slice < whole) {
            return 1 + (int) (slice % shards);
        }
        // In each frame the row begins elsewhere, as what is long in one is long in the next.
        long place = (places[tile] + slice * (long) (tiles.size() * GOLDEN)) % tiles.size();
        return 1 + (int) share(place * (slices - whole) + slice - whole);
    }

    /** In which share a place is, if all places are cut into shares of which none has more than one place more than another. */
    private long share(long place) {
        long all = tiles.size() * (slices - whole);
        long least = all / shards;
        long larger = all % shards;
        return place < larger * (least + 1) ? place / (least + 1) : larger + (place - larger * (least + 1)) / least;
    }
}
