package cz.paprsek.format.model;

import java.util.Arrays;

/** An array of numbers that grows as they come. */
public final class Ints {
    private int[] values = new int[64];
    private int size;

    public void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, larger(size));
        }
        values[size++] = value;
    }

    /** Twice as much, as far as an array can have it. */
    public static int larger(int size) {
        if (size >= Integer.MAX_VALUE - 8) {
            throw new OutOfMemoryError("more than " + size + " numbers");
        }
        return (int) Math.min(Integer.MAX_VALUE - 8L, 2L * size);
    }

    public int size() {
        return size;
    }

    public int get(int index) {
        return values[index];
    }

    /** Forgets all, and keeps the room. */
    public void clear() {
        size = 0;
    }

    public int[] toArray() {
        return values.length == size ? values : Arrays.copyOf(values, size);
    }
}
