package cz.paprsek.render.surface;

import cz.paprsek.shape.placed.Part;
import java.util.Arrays;
import java.util.Optional;

/** The primitives of a scene, numbered as they are placed: for each its geometry, its finish and the object it belongs to. Immutable. */
public final class PartTable {
    private final Part[] parts;
    private final Finish[] finishes;
    private final int[] objects;
    /** The first part of each object. */
    private final int[] firsts;
    private final int size;
    private final boolean hasPictures;
    /** The numbers of the parts that stand here in the place of others, rising, and these parts. */
    private final int[] exchanged;
    private final int firstExchanged;
    private final Part[] freshParts;
    private final Finish[] freshFinishes;
    private final boolean rough;

    /**
     * Takes over all that has been placed.
     *
     * @param firsts the first part of each object
     */
    PartTable(Placing all, int[] firsts) {
        this(all.parts, all.finishes, all.objects, firsts, all.size, all.hasPictures, new int[0], all.parts, all.finishes, all.isRough);
    }

    private PartTable(Part[] parts, Finish[] finishes, int[] objects, int[] firsts, int size, boolean hasPictures, int[] exchanged, Part[] freshParts, Finish[] freshFinishes,
            boolean rough) {
        this.parts = parts;
        this.finishes = finishes;
        this.objects = objects;
        this.firsts = firsts;
        this.size = size;
        this.hasPictures = hasPictures;
        this.exchanged = exchanged;
        this.firstExchanged = exchanged.length == 0 ? Integer.MAX_VALUE : exchanged[0];
        this.freshParts = freshParts;
        this.freshFinishes = freshFinishes;
        this.rough = rough;
    }

    /**
     * This table, in which nothing has been exchanged, with some objects placed anew, in the order in which they were; all else is
     * shared. Empty if one of them no longer has as many parts as it had.
     */
    Optional<PartTable> with(Placing fresh) {
        int[] numbers = new int[fresh.size];
        int next = 0;
        for (int k = 0; k < fresh.size; k++) {
            boolean isFirst = k == 0 || fresh.objects[k] != fresh.objects[k - 1];
            if (isFirst && k > 0 && !isEnd(next, fresh.objects[k - 1])) {
                return Optional.empty();
            }
            next = isFirst ? firsts[fresh.objects[k]] : next;
            if (isEnd(next, fresh.objects[k])) {
                return Optional.empty();
            }
            numbers[k] = next++;
        }
        return fresh.size == 0 || !isEnd(next, fresh.objects[fresh.size - 1]) ? Optional.empty()
                : Optional.of(new PartTable(parts, finishes, objects, firsts, size, hasPictures || fresh.hasPictures, numbers, fresh.parts, fresh.finishes, rough || fresh.isRough));
    }

    /** Whether an object has no part of a number. */
    private boolean isEnd(int number, int object) {
        return number >= size || objects[number] != object;
    }

    /** Whether some part is rough, or was before it was exchanged. */
    boolean isRough() {
        return rough;
    }

    public int size() {
        return size;
    }

    /** Whether any paint is a picture. */
    public boolean havePictures() {
        return hasPictures;
    }

    public Part part(int i) {
        int fresh = fresh(i);
        return fresh < 0 ? parts[i] : freshParts[fresh];
    }

    public Finish finish(int i) {
        int fresh = fresh(i);
        return fresh < 0 ? finishes[i] : freshFinishes[fresh];
    }

    private int fresh(int i) {
        return i < firstExchanged ? -1 : Arrays.binarySearch(exchanged, i);
    }

    /** The number of the scene's object that the part belongs to. */
    public int object(int i) {
        return objects[i];
    }

    /** The first part of the object that the part belongs to. */
    public int firstOfObject(int i) {
        return firsts[objects[i]];
    }

    /** The first part of an object. */
    int firstOf(int object) {
        return firsts[object];
    }
}
