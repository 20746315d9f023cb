package cz.paprsek.render.surface;

import java.util.Arrays;

/**
 * Scratch: the solids a ray is inside of. First the opaque ones that the camera stands in, of which only their presence counts; then the
 * transparent ones, in the order the ray entered them. The last one's refractive index counts.
 */
public final class Media {
    private static final double VACUUM = 1;

    private int[] object = new int[8];
    private double[] index = new double[8];
    private int size;
    private int opaque;
    /** The solids the ray has left in the place where it is. */
    private int[] passed = {};
    private int passedSize;

    /** The refractive index around the ray. */
    public double refractiveIndex() {
        return size == opaque ? VACUUM : index[size - 1];
    }

    /** The number of the transparent object entered last; −1 outside of all. */
    public int innermost() {
        return size == opaque ? -1 : object[size - 1];
    }

    /** Whether the ray is inside a transparent solid. */
    public boolean areAround() {
        return size > opaque;
    }

    /** How many transparent solids are around the ray. */
    public int count() {
        return size - opaque;
    }

    /** The number of the i-th transparent solid around the ray. */
    public int object(int i) {
        return object[opaque + i];
    }

    /** Whether the ray is inside a solid, transparent or not. */
    public boolean hold(int solid) {
        for (int i = 0; i < size; i++) {
            if (object[i] == solid) {
                return true;
            }
        }
        return false;
    }

    public void clear() {
        size = 0;
        opaque = 0;
        passedSize = 0;
    }

    /** Whether the ray has left a solid in the place where it is, going the way it goes. */
    public boolean havePassed(int solid) {
        for (int i = 0; i < passedSize; i++) {
            if (passed[i] == solid) {
                return true;
            }
        }
        return false;
    }

    /** Notes that the ray has left a solid in the place where it is. */
    public void pass(int solid) {
        if (passedSize == passed.length) {
            passed = Arrays.copyOf(passed, Math.max(4, 2 * passedSize));
        }
        passed[passedSize++] = solid;
    }

    /** The ray is in another place, or goes another way. */
    public void forgetPassed() {
        passedSize = 0;
    }

    /** Puts the ray into an opaque solid; to be done before it enters any other. */
    public void surround(int solid) {
        enter(solid, VACUUM);
        opaque = size;
    }

    public void set(Media other) {
        if ((other.size | other.passedSize) == 0) {
            clear();
            return;
        }
        size = other.size;
        opaque = other.opaque;
        if (size > object.length) {
            object = new int[other.object.length];
            index = new double[other.index.length];
        }
        // Nearly always none, one or two: a loop is done before System.arraycopy has begun.
        for (int i = 0; i < size; i++) {
            object[i] = other.object[i];
            index[i] = other.index[i];
        }
        passedSize = 0;
        for (int i = 0; i < other.passedSize; i++) {
            pass(other.passed[i]);
        }
    }

    /** Enters a solid. If the ray is in it already, it left unnoticed, through an edge thinner than rounding. */
    public void enter(int solid, double refractiveIndex) {
        leave(solid);
        if (size == object.length) {
            object = Arrays.copyOf(object, 2 * size);
            index = Arrays.copyOf(index, 2 * size);
        }
        object[size] = solid;
        index[size++] = refractiveIndex;
    }

    /** Leaves a solid, wherever it stands in the order; nothing happens if the ray is not in it. */
    public void leave(int solid) {
        int kept = 0;
        int keptOpaque = opaque;
        for (int i = 0; i < size; i++) {
            if (object[i] != solid) {
                object[kept] = object[i];
                index[kept++] = index[i];
            } else if (i < opaque) {
                keptOpaque--;
            }
        }
        size = kept;
        opaque = keptOpaque;
    }
}
