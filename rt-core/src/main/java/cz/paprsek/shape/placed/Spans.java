package cz.paprsek.shape.placed;

import java.util.Arrays;

/**
 * A stack of the boundaries that rays cross, in growing arrays that one worker keeps: {@code t[i]} is where, {@code part[i]} and
 * {@code face[i]} are what. A solid pushes its boundaries in the order of t, entering and leaving in turn, over the whole line;
 * t may be negative, or infinite for a body without end. A face is complemented where CSG turned it inside out.
 */
public final class Spans {
    /**
     * Boundaries of two operands nearer than this, relative to the numbers they come from, lie in one place and are crossed together,
     * so that a hole cut flush with a face leaves no skin.
     */
    private static final double TIE = Ray.TOUCH;

    private double[] t = new double[32];
    private int[] part = new int[32];
    private int[] face = new int[32];
    private int size;

    /** How many boundaries there are. */
    public int size() {
        return size;
    }

    public double t(int i) {
        return t[i];
    }

    public int part(int i) {
        return part[i];
    }

    public int face(int i) {
        return face[i];
    }

    /** Forgets the boundaries from {@code mark} on. */
    public void release(int mark) {
        size = mark;
    }

    /** Whether the stretches from {@code mark} on reach between the ray's min and max. */
    public boolean reaches(int mark, Ray ray) {
        return size > mark && t[mark] < ray.reach && t[size - 1] > ray.min;
    }

    /** Pushes a boundary. */
    public void add(double where, int ofPart, int ofFace) {
        if (size == t.length) {
            grow(size + 1);
        }
        put(size++, where, ofPart, ofFace);
    }

    /**
     * Replaces the two sorted runs [left, right) and [right, size) by the boundaries of their combination: wherever the operation's
     * answer changes there is one boundary. Where both change in one place the left one is kept.
     *
     * @param scale the size of the numbers behind the ray's origin
     */
    public void combine(Combination operation, int left, int right, double scale) {
        if (left == right || right == size || together(t[right - 1], scale) < t[right] || together(t[size - 1], scale) < t[left]) {
            combineApart(operation, left, right, scale);
        } else {
            merge(operation, left, right, scale);
        }
    }

    /**
     * The same for a run and the single stretch of a convex body, without pushing that: its ends take their places among the others.
     *
     * @return false, and nothing has changed, if anything lies in one place with anything else
     */
    boolean combine(Combination operation, int left, double enter, int enterFace, double leave, int leaveFace, int ofPart, double scale) {
        double near = 2 * TIE;
        boolean areApart = leave - enter > near * (scale + Math.abs(enter) + Math.abs(leave));
        int before = left;
        int until = left;
        for (int i = left; i < size && areApart; i++) {
            double at = t[i];
            before += at < enter ? 1 : 0;
            until += at < leave ? 1 : 0;
            double reach = near * (scale + Math.abs(at));
            areApart = Math.abs(at - enter) > reach && Math.abs(at - leave) > reach && (i == left || at - t[i - 1] > reach);
        }
        if (!areApart) {
            return false;
        }
        boolean keepsOutside = operation.inside(true, false);
        boolean keepsInside = operation.inside(false, true) != operation.inside(true, true);
        boolean flips = keepsOutside && !operation.inside(false, true);
        boolean hasEnter = changes(operation, before - left);
        boolean hasLeave = changes(operation, until - left);
        int added = (hasEnter ? 1 : 0) + (hasLeave ? 1 : 0);
        int kept = keepsOutside ? before : left;
        int middle = keepsInside ? until - before : 0;
        int tail = keepsOutside ? size - until : 0;
        grow(size + added);
        // What comes last is moved first if the run grows, and last if it shrinks.
        int newMiddle = kept + (hasEnter ? 1 : 0);
        int newTail = newMiddle + middle + (hasLeave ? 1 : 0);
        move(until, newTail, newTail > until ? tail : 0);
        move(before, newMiddle, middle);
        move(until, newTail, newTail > until ? 0 : tail);
        if (hasEnter) {
            put(kept, enter, ofPart, flips ? ~enterFace : enterFace);
        }
        if (hasLeave) {
            put(newTail - 1, leave, ofPart, flips ? ~leaveFace : leaveFace);
        }
        size = newTail + tail;
        return true;
    }

    /** Whether the right solid's boundary is one of the combination, given how many of the left one's lie before it. */
    private static boolean changes(Combination operation, int before) {
        boolean inLeft = before % 2 != 0;
        return operation.inside(inLeft, false) != operation.inside(inLeft, true);
    }

    private void move(int from, int to, int count) {
        if (to > from) {
            for (int i = count - 1; i >= 0; i--) {
                put(to + i, t[from + i], part[from + i], face[from + i]);
            }
        } else if (to < from) {
            for (int i = 0; i < count; i++) {
                put(to + i, t[from + i], part[from + i], face[from + i]);
            }
        }
    }

    private void put(int at, double where, int ofPart, int ofFace) {
        t[at] = where;
        part[at] = ofPart;
        face[at] = ofFace;
    }

    /** Combines two runs of which one is empty, or ends before the other begins. */
    private void combineApart(Combination operation, int left, int right, double scale) {
        if (!operation.inside(false, true)) {
            size = operation.inside(true, false) ? right : left;
        } else if (left < right && right < size && t[right] < t[left]) {
            merge(operation, left, right, scale);
        }
    }

    private void merge(Combination operation, int left, int right, double scale) {
        int end = size;
        grow(end + end - left);
        int a = left;
        int b = right;
        boolean flips = !operation.inside(false, true) && operation.inside(true, false);
        boolean inA = false;
        boolean inB = false;
        boolean inside = false;
        while (a < right || b < end) {
            double first = b == end || (a < right && t[a] <= t[b]) ? t[a] : t[b];
            double together = together(first, scale);
            int fromA = a;
            while (a < right && t[a] <= together) {
                a++;
            }
            int fromB = b;
            while (b < end && t[b] <= together) {
                b++;
            }
            boolean changedA = (a - fromA) % 2 != 0;
            inA ^= changedA;
            inB ^= (b - fromB) % 2 != 0;
            if (operation.inside(inA, inB) != inside) {
                inside = !inside;
                int source = changedA ? fromA : fromB;
                boolean flipped = !changedA && flips;
                add(t[source], part[source], flipped ? ~face[source] : face[source]);
            }
        }
        int count = size - end;
        System.arraycopy(t, end, t, left, count);
        System.arraycopy(part, end, part, left, count);
        System.arraycopy(face, end, face, left, count);
        size = left + count;
    }

    /** Up to where boundaries count as lying in the same place as the one at {@code first}. */
    private static double together(double first, double scale) {
        return Double.isInfinite(first) ? first : first + TIE * (scale + Math.abs(first));
    }

    /**
     * Drops of a primitive's boundaries, from {@code mark} on, the one that the ray starts at, and those before it. It is the nearest to the
     * start of those that lead the way the ray goes.
     */
    public void leaveFrom(int mark, boolean inwards) {
        int start = -1;
        for (int i = inwards ? mark : mark + 1; i < size; i += 2) {
            if (start < 0 || Math.abs(t[i]) < Math.abs(t[start])) {
                start = i;
            }
        }
        if (start < 0) {
            return;
        }
        int kept = mark;
        for (int i = inwards ? start : start + 1; i < size; i++) {
            t[kept] = i == start ? Double.NEGATIVE_INFINITY : Math.max(t[i], 0);
            part[kept] = part[i];
            face[kept++] = face[i];
        }
        size = kept;
    }

    /**
     * Takes the run [from, size) out of the space of a copy.
     *
     * @param growth how often as fast t grows there
     * @param first the number of its first part
     */
    public void carry(int from, double growth, int first) {
        for (int i = from; i < size; i++) {
            t[i] /= growth;
            part[i] += first;
        }
    }

    /** Keeps of the run [from, size) only the boundaries strictly between two values of t. */
    public void clip(int from, double min, double max) {
        int kept = from;
        for (int i = from; i < size; i++) {
            if (t[i] > min && t[i] < max) {
                t[kept] = t[i];
                part[kept] = part[i];
                face[kept++] = face[i];
            }
        }
        size = kept;
    }

    private void grow(int capacity) {
        if (capacity > t.length) {
            int length = Math.max(capacity, 2 * t.length);
            t = Arrays.copyOf(t, length);
            part = Arrays.copyOf(part, length);
            face = Arrays.copyOf(face, length);
        }
    }
}
