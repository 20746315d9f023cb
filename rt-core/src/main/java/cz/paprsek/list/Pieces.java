package cz.paprsek.list;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.RandomAccess;
import java.util.function.Predicate;

/**
 * An immutable list in pieces: one in which some elements have changed shares all other pieces with it. So both are made, and told
 * apart, in a time that hardly grows with the list.
 */
public final class Pieces<T> extends AbstractList<T> implements RandomAccess {
    /** Says of no element that it counts as another one. */
    public static final Predicate<Object> NONE = element -> false;

    private static final int BITS = 8;
    private static final int SIDE = 1 << BITS;

    private final Object[][] pieces;
    private final int size;
    /** That together with which all elements have been checked. */
    private final Object checkedWith;

    private Pieces(Object[][] pieces, int size, Object checkedWith) {
        this.pieces = pieces;
        this.size = size;
        this.checkedWith = checkedWith;
    }

    /** A copy that nobody has checked; the very list if it is one of these. */
    public static <T> Pieces<T> of(List<T> list) {
        if (list instanceof Pieces<T> known) {
            return known;
        }
        Object[] all = list.toArray();
        Arrays.stream(all).forEach(Objects::requireNonNull);
        Object[][] pieces = new Object[(all.length + SIDE - 1) / SIDE][];
        for (int i = 0; i < pieces.length; i++) {
            pieces[i] = Arrays.copyOfRange(all, i * SIDE, Math.min(all.length, (i + 1) * SIDE));
        }
        return new Pieces<>(pieces, all.length, pieces);
    }

    /** As {@link #of}, sharing those pieces of this list that are the same. */
    public Pieces<T> like(List<T> list) {
        Pieces<T> copy = of(list);
        Object[][] shared = copy.pieces.clone();
        for (int i = 0; i < Math.min(pieces.length, shared.length); i++) {
            shared[i] = isSame(pieces[i], shared[i]) ? pieces[i] : shared[i];
        }
        return copy == list ? copy : new Pieces<>(shared, copy.size, shared);
    }

    /** With some more at the end, which nobody has checked. */
    public Pieces<T> plus(List<? extends T> more) {
        Object[][] longer = Arrays.copyOf(pieces, (size + more.size() + SIDE - 1) / SIDE);
        for (int i = size / SIDE; i < longer.length; i++) {
            Object[] piece = i < pieces.length ? pieces[i] : new Object[0];
            int begin = piece.length;
            longer[i] = Arrays.copyOf(piece, Math.min(SIDE, size + more.size() - i * SIDE));
            for (int k = begin; k < longer[i].length; k++) {
                longer[i][k] = Objects.requireNonNull(more.get(i * SIDE + k - size));
            }
        }
        return new Pieces<>(longer, size + more.size(), longer);
    }

    /** With other elements at some indexes, which nobody has checked. */
    public Pieces<T> with(Map<Integer, T> changes) {
        Object[][] changed = pieces.clone();
        changes.forEach((index, element) -> {
            int i = index >> BITS;
            changed[i] = changed[i] == pieces[i] ? pieces[i].clone() : changed[i];
            changed[i][index & SIDE - 1] = Objects.requireNonNull(element);
        });
        return new Pieces<>(changed, size, changed);
    }

    public Pieces<T> checkedWith(Object others) {
        return isCheckedWith(others) ? this : new Pieces<>(pieces, size, others);
    }

    public boolean isCheckedWith(Object others) {
        return checkedWith == others;
    }

    /** The indexes of the elements that are not the very same as in another list, or beyond its end; rising. */
    public int[] otherThanIn(Pieces<T> other) {
        int[] found = new int[SIDE];
        int count = 0;
        for (int i = 0; i < pieces.length; i++) {
            Object[] theirs = i < other.pieces.length ? other.pieces[i] : new Object[0];
            for (int k = 0; k < pieces[i].length && pieces[i] != theirs; k++) {
                if (k >= theirs.length || pieces[i][k] != theirs[k]) {
                    found = count == found.length ? Arrays.copyOf(found, 2 * count) : found;
                    found[count++] = (i << BITS) + k;
                }
            }
        }
        return Arrays.copyOf(found, count);
    }

    /** How many elements from an index on, the same in both, are known to be shared with another list. */
    int shared(Pieces<T> other, int index) {
        int piece = index >> BITS;
        return (index & SIDE - 1) == 0 && piece < Math.min(pieces.length, other.pieces.length) && pieces[piece] == other.pieces[piece] ? pieces[piece].length : 0;
    }

    private static boolean isSame(Object[] a, Object[] b) {
        boolean same = a.length == b.length;
        for (int i = 0; same && i < a.length; i++) {
            same = a[i] == b[i];
        }
        return same;
    }

    @Override
    @SuppressWarnings("unchecked")
    public T get(int index) {
        return (T) pieces[Objects.checkIndex(index, size) >> BITS][index & SIDE - 1];
    }

    @Override
    public Object[] toArray() {
        Object[] all = new Object[size];
        for (int i = 0; i < pieces.length; i++) {
            System.arraycopy(pieces[i], 0, all, i * SIDE, pieces[i].length);
        }
        return all;
    }

    @Override
    public int size() {
        return size;
    }

    /** What is shared is not looked at. */
    @Override
    public boolean equals(Object other) {
        if (!(other instanceof Pieces<?> known)) {
            return super.equals(other);
        }
        boolean same = size == known.size;
        for (int i = 0; same && i < pieces.length; i++) {
            same = pieces[i] == known.pieces[i] || Arrays.equals(pieces[i], known.pieces[i]);
        }
        return same;
    }

    @Override
    public int hashCode() {
        return super.hashCode();
    }
}
