package cz.paprsek.render;

import java.util.Arrays;

/** Scratch: the transparent solids a ray is inside of, in the order it entered them. The last one's refractive index counts. */
final class Media {
    private static final double VACUUM = 1;

    private int[] object = new int[8];
    private double[] index = new double[8];
    private int size;

    /** The refractive index around the ray. */
    double refractiveIndex() {
        return size == 0 ? VACUUM : index[size - 1];
    }

    /** The number of the object entered last; −1 outside of all. */
    int innermost() {
        return size == 0 ? -1 : object[size - 1];
    }

    void clear() {
        size = 0;
    }

    void set(Media other) {
        size = other.size;
        if (size > object.length) {
            object = new int[other.object.length];
            index = new double[other.index.length];
        }
        // Nearly always none, one or two: a loop is done before System.arraycopy has begun.
        for (int i = 0; i < size; i++) {
            object[i] = other.object[i];
            index[i] = other.index[i];
        }
    }

    /** Enters a solid. If the ray is in it already, it left unnoticed, through an edge thinner than the offset of rays. */
    void enter(int solid, double refractiveIndex) {
        leave(solid);
        if (size == object.length) {
            object = Arrays.copyOf(object, 2 * size);
            index = Arrays.copyOf(index, 2 * size);
        }
        object[size] = solid;
        index[size++] = refractiveIndex;
    }

    /** Leaves a solid, wherever it stands in the order; nothing happens if the ray is not in it. */
    void leave(int solid) {
        int kept = 0;
        for (int i = 0; i < size; i++) {
            if (object[i] != solid) {
                object[kept] = object[i];
                index[kept++] = index[i];
            }
        }
        size = kept;
    }
}
