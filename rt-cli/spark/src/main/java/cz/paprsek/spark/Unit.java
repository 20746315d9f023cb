package cz.paprsek.spark;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;

/**
 * What a task does: tiles of a frame, by their numbers.
 *
 * @param frame from 1; 0 of a picture that is no film
 * @param from number of the first tile, from 0
 * @param to number after that of the last
 * @param isWhole whether that is all of the frame, whose picture is written at once
 */
record Unit(int frame, int from, int to, boolean isWhole) implements Serializable {
    private static final long serialVersionUID = 1;

    /** Frames, each by itself. */
    static List<Unit> frames(int first, int last, int tiles) {
        List<Unit> units = new ArrayList<>();
        for (int frame = first; frame <= last; frame++) {
            units.add(new Unit(frame, 0, tiles, true));
        }
        return units;
    }

    /** Tiles, each by itself. */
    static List<Unit> tiles(int first, int last, int tiles) {
        List<Unit> units = new ArrayList<>();
        for (int frame = first; frame <= last; frame++) {
            for (int tile = 0; tile < tiles; tile++) {
                units.add(new Unit(frame, tile, tile + 1, false));
            }
        }
        return units;
    }
}
