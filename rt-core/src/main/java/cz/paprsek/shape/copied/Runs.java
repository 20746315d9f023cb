package cz.paprsek.shape.copied;

import cz.paprsek.shape.placed.Part;
import java.util.Arrays;

/**
 * Where copies stand among parts that are counted one after the other. A copy takes as many places as its original has parts, but of what is kept for parts
 * only as many as that has {@linkplain Original#scopes scopes}: what is kept for a place stands at its {@link #slot}.
 */
public final class Runs {
    private int[] starts = {};
    private int[] slots = {};
    private Copy[] copies = {};
    private int size;

    /** Adds a copy behind all others, from a place on, and a slot on. */
    public void add(int place, int slot, Copy copy) {
        if (size == starts.length) {
            int length = Math.max(16, 2 * size);
            starts = Arrays.copyOf(starts, length);
            slots = Arrays.copyOf(slots, length);
            copies = Arrays.copyOf(copies, length);
        }
        starts[size] = place;
        slots[size] = slot;
        copies[size++] = copy;
    }

    /** How many copies there are. */
    public int size() {
        return size;
    }

    /** The slot of a place. */
    public int slot(int place) {
        int run = size == 0 ? -1 : find(place);
        if (run < 0) {
            return place;
        }
        Original original = copies[run].original();
        int within = place - starts[run];
        return slots[run] + (within < original.count() ? original.scope(within) : within - original.count() + original.scopes());
    }

    /**
     * The part at a place.
     *
     * @param alone those of the slots
     * @param scratch becomes the part if it is one of a copy
     */
    public Part part(int place, Part[] alone, CopiedPart scratch) {
        int run = size == 0 ? -1 : find(place);
        if (run < 0) {
            return alone[place];
        }
        int within = place - starts[run];
        return within < copies[run].original().count() ? scratch.become(copies[run], within) : alone[slot(place)];
    }

    /** The place behind that of a part, or behind all places of the copy that it is one of. */
    public int after(int place) {
        int run = size == 0 ? -1 : find(place);
        return run < 0 ? place + 1 : Math.max(place + 1, starts[run] + copies[run].original().count());
    }

    /** The last copy that begins at a place or before it; −1 if there is none. */
    private int find(int place) {
        int at = Arrays.binarySearch(starts, 0, size, place);
        return at >= 0 ? at : -at - 2;
    }
}
