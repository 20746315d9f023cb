package cz.paprsek.shape.placed;

import java.util.Arrays;

/** Scratch of one worker: whole numbers, in a growing array. */
public final class IntStack {
    private int[] values = new int[32];
    private int size;

    public int size() {
        return size;
    }

    public int get(int i) {
        return values[i];
    }

    public void push(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, 2 * size);
        }
        values[size++] = value;
    }

    /** Forgets the numbers from {@code mark} on. */
    public void release(int mark) {
        size = mark;
    }

    /** Sorts the numbers from {@code mark} on. */
    public void sort(int mark) {
        Arrays.sort(values, mark, size);
    }
}
