package cz.paprsek.cli.shard;

import cz.paprsek.cli.value.Shard;
import cz.paprsek.render.Tile;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Predicate;

/**
 * How the work on a picture, or on the frames of a film, is dealt out, in parts of which each becomes a file. It depends on nothing but the picture and the
 * number of shares; that of a share takes as long as that of any other, about, as of each few neighbours in picture and time everybody gets one. Of many frames
 * everybody gets whole ones, as each must be prepared by whoever renders something of it.
 */
final class Deal {
    /** How many parts a share has at least, if the picture is large enough: who is killed loses one of them. */
    private static final int PARTS = 256;
    private static final int LARGEST_SIDE = 512;
    /** From so many frames for each share on, they are dealt out as a whole. */
    private static final int FRAMES = 8;
    private static final double GOLDEN = 0.618033988749895;

    private final List<Tile> tiles;
    private final int first;
    private final int frames;
    private final int shards;

    /**
     * A piece of work.
     *
     * @param frame from 1; 0 of a picture that is no film
     */
    record Piece(int frame, Tile tile) {}

    Deal(Tile region, Span span, int shards) {
        this.first = span.first();
        this.shards = shards;
        frames = span.count();
        tiles = Grid.tiles(region, side(region, frames, (long) PARTS * shards));
    }

    /** The largest side of tiles with which there are so many of them, if there can be. */
    static int side(Tile region, int frames, long wanted) {
        int side = LARGEST_SIDE;
        while (side > Grid.SIDE && (long) Grid.cells(region.width(), side) * Grid.cells(region.height(), side) * frames < wanted) {
            side -= Grid.SIDE;
        }
        return side;
    }

    /** How many parts there are. */
    long parts() {
        return (long) tiles.size() * frames;
    }

    /** What a share has to do, frame by frame. */
    List<Piece> of(Shard shard) {
        List<Piece> own = new ArrayList<>();
        for (int frame = 0; frame < frames; frame++) {
            for (int i = 0; i < tiles.size(); i++) {
                if (owner(frame, i) == shard.number()) {
                    own.add(new Piece(first + frame, tiles.get(i)));
                }
            }
        }
        return own;
    }

    /** Whose work some pieces are, in order. */
    List<Integer> owners(Predicate<Piece> which) {
        SortedSet<Integer> owners = new TreeSet<>();
        for (int frame = 0; frame < frames; frame++) {
            for (int i = 0; i < tiles.size(); i++) {
                if (which.test(new Piece(first + frame, tiles.get(i)))) {
                    owners.add(owner(frame, i));
                }
            }
        }
        return List.copyOf(owners);
    }

    /** Whose work a tile is. */
    private int owner(int frame, int tile) {
        if (frames >= (long) FRAMES * shards) {
            return 1 + frame % shards;
        }
        long number = (long) frame * tiles.size() + tile;
        // In each round everybody has another turn, or a share would get a stripe of the picture.
        long round = number / shards;
        double turn = round * GOLDEN;
        return 1 + (int) ((number % shards + (long) (shards * (turn - Math.floor(turn)))) % shards);
    }
}
