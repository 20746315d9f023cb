package cz.paprsek.render.show;

import java.util.Arrays;

/** Sums of a pixel's samples of which floats are kept from pass to pass. Scratch of one worker. */
final class KeptSums {
    private final double[] sums;

    KeptSums(int size) {
        sums = new double[size];
    }

    void clear() {
        Arrays.fill(sums, 0);
    }

    void add(int number, double value) {
        sums[number] += value;
    }

    double at(int number) {
        return sums[number];
    }

    /** Rounds the sums to what is kept of them. */
    void round() {
        for (int i = 0; i < sums.length; i++) {
            sums[i] = (float) sums[i];
        }
    }

    /** Keeps the sums, from a place on; where what follows them begins. */
    int save(float[] numbers, int from) {
        for (int i = 0; i < sums.length; i++) {
            numbers[from + i] = (float) sums[i];
        }
        return from + sums.length;
    }

    /** Goes on with sums that were kept, from a place on; where what follows them begins. */
    int load(float[] numbers, int from) {
        for (int i = 0; i < sums.length; i++) {
            sums[i] = numbers[from + i];
        }
        return from + sums.length;
    }
}
