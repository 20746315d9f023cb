package cz.paprsek.cli.shard;

import cz.paprsek.render.Tile;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/** What is there of a frame: cells of which all is, and cells of which some passes are. */
final class Coverage {
    /** All passes of these, in parts that have all or in one for each. */
    private final Grid whole;
    private final SortedMap<Integer, Grid> passes = new TreeMap<>();

    /** What is there by some parts, all of one frame. */
    Coverage(Card card, List<PartHead> parts) {
        Grid own = new Grid(card.region());
        parts.stream().filter(part -> part.pass() == 0).forEach(part -> own.cover(part.tile()));
        parts.stream().filter(part -> part.pass() > 0).forEach(part -> passes.computeIfAbsent(part.pass(), pass -> own.copy()).cover(part.tile()));
        whole = card.passes() > 0 && passes.size() == card.passes() ? passes.values().stream().reduce(Grid::and).orElseThrow() : own;
    }

    /** Whether all of a tile is there. */
    boolean covers(Tile tile) {
        return whole.covers(tile);
    }

    /** Whether a pass of a tile is there, from 1; 0 for all. */
    boolean covers(int pass, Tile tile) {
        return passes.getOrDefault(pass, whole).covers(tile);
    }

    /** Whether there are parts of single passes. */
    boolean isInPasses() {
        return !passes.isEmpty();
    }
}
