package cz.paprsek.list;

import java.util.Arrays;
import java.util.function.Predicate;

/**
 * What has to be taken out of a list, and put into it, to make another of it. What is in neither is the very same in both, in the same order: an element
 * that is exchanged is taken out and another put in.
 */
public final class Difference {
    /** Of two lists that are alike. */
    public static final Difference NONE = new Difference(new int[0], new int[0], new int[0]);

    /** How far two lists are searched for where they go on alike. */
    private static final int FARTHEST = 1024;

    private final int[] removed;
    private final int[] added;
    private final int[] places;

    private Difference(int[] removed, int[] added, int[] places) {
        this.removed = removed;
        this.added = added;
        this.places = places;
    }

    /** Indexes in the one, rising; not to be changed. */
    public int[] removed() {
        return removed;
    }

    /** Indexes in the other, rising; not to be changed. */
    public int[] added() {
        return added;
    }

    /** For each that is added, the index in the one that it comes before, of those left; rising, and not to be changed. */
    public int[] places() {
        return places;
    }

    /** Whether nothing is different. */
    public boolean isNone() {
        return removed.length == 0 && added.length == 0;
    }

    /** Whether an element of the one is left. */
    public boolean keeps(int index) {
        return removed.length == 0 || Arrays.binarySearch(removed, index) < 0;
    }

    /** The index in the other list of an element of the one that is left. */
    public int moved(int index) {
        return index - countBelow(removed, index) + countBelow(places, index + 1);
    }

    private static int countBelow(int[] rising, int limit) {
        int low = 0;
        int high = rising.length;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (rising[middle] < limit) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /**
     * The difference of two lists: not the smallest there is, but small where one was made from the other by a few edits. What they share as
     * {@link Pieces} is not looked at.
     *
     * @param isOther which elements count as other ones, be they the same or not
     * @param most of how many removed or added it is given up; then that many, and some more, are told
     */
    public static <T> Difference of(Pieces<T> one, Pieces<T> other, Predicate<? super T> isOther, int most) {
        return new Search<>(one, other, isOther, most).found();
    }

    /** As {@link #of(Pieces, Pieces, Predicate, int)}, however much is different. */
    public static <T> Difference of(Pieces<T> one, Pieces<T> other) {
        return of(one, other, Pieces.NONE, Integer.MAX_VALUE);
    }

    /** Goes along both lists at once. */
    private static final class Search<T> {
        private final Pieces<T> one;
        private final Pieces<T> other;
        private final Predicate<? super T> isOther;
        private final int most;
        private final Rising removed = new Rising();
        private final Rising added = new Rising();
        private final Rising places = new Rising();
        private int i;
        private int j;
        private int farthest = FARTHEST;

        Search(Pieces<T> one, Pieces<T> other, Predicate<? super T> isOther, int most) {
            this.one = one;
            this.other = other;
            this.isOther = isOther;
            this.most = most;
        }

        Difference found() {
            while ((i < one.size() || j < other.size()) && removed.size <= most && added.size <= most) {
                int shared = isOther == Pieces.NONE && i == j ? one.shared(other, i) : 0;
                if (shared > 0) {
                    i += shared;
                    j += shared;
                } else if (isSame(0, 0)) {
                    i++;
                    j++;
                } else {
                    goOn();
                }
            }
            return new Difference(removed.all(), added.all(), places.all());
        }

        /** Goes past what is different. Where nothing is found alike, not much is looked for the next time. */
        private void goOn() {
            if (i < one.size() && j < other.size() && !isSame(1, 1)) {
                for (int d = 1; d <= farthest; d++) {
                    if (isSame(d, 0)) {
                        skip(d, 0);
                        farthest = FARTHEST;
                        return;
                    } else if (isSame(0, d)) {
                        skip(0, d);
                        farthest = FARTHEST;
                        return;
                    }
                }
                farthest = Math.max(1, farthest / 2);
            }
            skip(i < one.size() ? 1 : 0, j < other.size() ? 1 : 0);
        }

        private boolean isSame(int ahead, int otherAhead) {
            return i + ahead < one.size() && j + otherAhead < other.size() && one.get(i + ahead) == other.get(j + otherAhead) && !isOther.test(one.get(i + ahead));
        }

        private void skip(int ones, int others) {
            for (int k = 0; k < ones; k++) {
                removed.add(i++);
            }
            for (int k = 0; k < others; k++) {
                places.add(i);
                added.add(j++);
            }
        }
    }

    /** Numbers that are gathered. */
    private static final class Rising {
        private int[] numbers = new int[16];
        private int size;

        void add(int number) {
            if (size == numbers.length) {
                numbers = Arrays.copyOf(numbers, 2 * size);
            }
            numbers[size++] = number;
        }

        int[] all() {
            return Arrays.copyOf(numbers, size);
        }
    }
}
