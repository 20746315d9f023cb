package cz.paprsek.format.model;

import java.util.Arrays;

/** An array of numbers that grows as they come. */
public final class Floats {
    private float[] values = new float[64];
    private int size;

    public void add(float value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, Ints.larger(size));
        }
        values[size++] = value;
    }

    public int size() {
        return size;
    }

    public float get(int index) {
        return values[index];
    }

    /** Forgets all, and keeps the room. */
    public void clear() {
        size = 0;
    }

    public float[] toArray() {
        return values.length == size ? values : Arrays.copyOf(values, size);
    }
}
