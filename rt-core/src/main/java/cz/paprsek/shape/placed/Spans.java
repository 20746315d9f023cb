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
        t[size] = where;
        part[size] = ofPart;
        face[size++] = ofFace;
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
