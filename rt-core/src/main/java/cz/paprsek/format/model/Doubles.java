package cz.paprsek.format.model;

import java.util.Arrays;

/** An array of numbers that grows as they come. */
public final class Doubles {
    private double[] values = new double[64];
    private int size;

    public void add(double value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, Ints.larger(size));
        }
        values[size++] = value;
    }

    /** Adds some numbers of an array. */
    public void add(double[] from, int first, int count) {
        while (size + count > values.length) {
            values = Arrays.copyOf(values, Ints.larger(values.length));
        }
        System.arraycopy(from, first, values, size, count);
        size += count;
    }

    public int size() {
        return size;
    }

    public double get(int index) {
        return values[index];
    }

    public void set(int index, double value) {
        values[index] = value;
    }

    /** Forgets all, and keeps the room. */
    public void clear() {
        size = 0;
    }

    public double[] toArray() {
        return values.length == size ? values : Arrays.copyOf(values, size);
    }
}
