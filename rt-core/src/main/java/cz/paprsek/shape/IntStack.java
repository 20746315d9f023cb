package cz.paprsek.shape;

import java.util.Arrays;

/** Scratch of one worker: whole numbers, in a growing array. */
final class IntStack {
    private int[] values = new int[32];
    private int size;

    int size() {
        return size;
    }

    int get(int i) {
        return values[i];
    }

    void push(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, 2 * size);
        }
        values[size++] = value;
    }

    /** Forgets the numbers from {@code mark} on. */
    void release(int mark) {
        size = mark;
    }

    /** Sorts the numbers from {@code mark} on. */
    void sort(int mark) {
        Arrays.sort(values, mark, size);
    }
}
