package cz.paprsek.render.surface;

import cz.paprsek.shape.copied.CopiedPart;
import cz.paprsek.shape.copied.Original;
import cz.paprsek.shape.copied.Runs;
import cz.paprsek.shape.placed.Part;
import java.util.Arrays;

/**
 * The primitives of a scene, numbered as they are placed: for each its geometry, its finish and the object it belongs to. Those of copies have numbers,
 * but only what they are made of is kept for each copy. Numbers are {@value #APART} apart, so that what is placed later finds room between its neighbours: of parts in one place the lowest number counts. Immutable.
 */
public final class PartTable {
    private static final int BITS = Original.BITS;
    private static final int APART = 1 << BITS;

    private final Part[] parts;
    private final Finish[] finishes;
    private final int[] objects;
    /** Where among these copies stand. */
    private final Runs runs;
    private final boolean hasNoCopies;
    /** The number of the first part of each object. */
    private final int[] firsts;
    private final int end;
    private final boolean hasPictures;
    private final boolean rough;
    /** What has been placed later: the numbers of single parts and of the first of a copy, rising, none of them a multiple, and their places; the first part of each object. */
    private final int[] numbers;
    private final int[] starts;
    private final Runs freshRuns;
    private final Part[] freshParts;
    private final Finish[] freshFinishes;
    private final int[] freshObjects;
    private final int[] freshFirsts;

    /**
     * Takes over all that has been placed.
     *
     * @param firsts the number of the first part of each object
     */
    PartTable(Placing all, int[] firsts) {
        this.parts = all.parts;
        this.finishes = all.finishes;
        this.objects = all.objects;
        this.runs = all.runs;
        this.hasNoCopies = runs.size() == 0;
        this.firsts = firsts;
        this.end = number(all.places);
        this.hasPictures = all.hasPictures;
        this.rough = all.isRough;
        this.numbers = new int[0];
        this.starts = numbers;
        this.freshRuns = runs;
        this.freshParts = all.parts;
        this.freshFinishes = all.finishes;
        this.freshObjects = all.objects;
        this.freshFirsts = numbers;
    }

    private PartTable(PartTable all, Placing fresh, int[] freshFirsts) {
        this.parts = all.parts;
        this.finishes = all.finishes;
        this.objects = all.objects;
        this.runs = all.runs;
        this.hasNoCopies = runs.size() == 0;
        this.firsts = all.firsts;
        this.numbers = Arrays.copyOf(fresh.numbers, fresh.count);
        this.starts = Arrays.copyOf(fresh.starts, fresh.count);
        this.freshRuns = fresh.runs;
        this.end = numbers.length == 0 ? all.end : Math.max(all.end, fresh.last + 1);
        this.hasPictures = all.hasPictures || fresh.hasPictures;
        this.rough = all.rough || fresh.isRough;
        this.freshParts = fresh.parts;
        this.freshFinishes = fresh.finishes;
        this.freshObjects = fresh.objects;
        this.freshFirsts = freshFirsts;
    }

    /** The number of what is placed first, in a certain place. */
    static int number(int place) {
        return place << BITS;
    }

    /** The number after one, of what is placed later. */
    static int after(int number) {
        return isFirst(number + 1) ? number + 2 : number + 1;
    }

    /**
     * This table, to which nothing has been added, with other objects beside those it has, in the order of their numbers; all else is shared.
     *
     * @param freshFirsts the number of the first part of each
     */
    PartTable with(Placing fresh, int[] freshFirsts) {
        return new PartTable(this, fresh, freshFirsts);
    }

    /** Whether some part is rough, or was before it was exchanged. */
    boolean isRough() {
        return rough;
    }

    /** A number that all parts have lower ones than. */
    public int end() {
        return end;
    }

    /** Whether any paint is a picture, or any finish asks for the place. */
    public boolean havePictures() {
        return hasPictures;
    }

    /** @param scratch becomes the part if it is one of a copy */
    public Part part(int i, CopiedPart scratch) {
        return isAlone(i) ? parts[i >> BITS] : isFirst(i) ? runs.part(i >> BITS, parts, scratch) : freshRuns.part(fresh(i), freshParts, scratch);
    }

    public Finish finish(int i) {
        return isAlone(i) ? finishes[i >> BITS] : isFirst(i) ? finishes[runs.slot(i >> BITS)] : freshFinishes[freshRuns.slot(fresh(i))];
    }

    /** The object that the part belongs to. */
    public int object(int i) {
        return isAlone(i) ? objects[i >> BITS] : isFirst(i) ? objects[runs.slot(i >> BITS)] : freshObjects[freshRuns.slot(fresh(i))];
    }

    /** Whether what is kept for a part stands at its own place, as all does that was placed first where there are no copies. */
    private boolean isAlone(int i) {
        return hasNoCopies && isFirst(i);
    }

    /** Whether a part was placed at first. */
    private static boolean isFirst(int i) {
        return (i & APART - 1) == 0;
    }

    /** The place of a part that was placed later. */
    private int fresh(int i) {
        int at = Arrays.binarySearch(numbers, i);
        int from = at >= 0 ? at : -at - 2;
        return starts[from] + ((i - numbers[from]) >> BITS);
    }

    /** The first part of the object that the part belongs to. */
    public int firstOfObject(int i) {
        return firstOf(object(i));
    }

    /** How many parts of its object are before a part. */
    public int placeInObject(int i) {
        int first = firstOfObject(i);
        return isFirst(i) ? (i - first) >> BITS : fresh(i) - fresh(first);
    }

    /** The first part of an object. */
    public int firstOf(int object) {
        return object < firsts.length ? firsts[object] : freshFirsts[object - firsts.length];
    }

    /** The last part of an object of those that were placed first. */
    int lastOf(int object) {
        int place = firsts[object] >> BITS;
        int last = place;
        while (number(place) < end && objects[runs.slot(place)] == object) {
            place = runs.after(place);
            last = place - 1;
        }
        return number(last);
    }
}
