package cz.paprsek.teach.grade;

import java.math.BigInteger;

/**
 * Which pixels of a picture are looked at: all of a small one, else some. Any first ones of them are spread evenly.
 *
 * @source Weyl, multiples of the golden ratio; no pixel is met twice, since the number of pixels and the stride have no common divisor
 */
record Places(int width, int height, int count, long stride) {
    private static final double GOLDEN = 0.618033988749895;

    static Places of(int width, int height, int most) {
        long pixels = (long) width * height;
        long stride = Math.max(1, (long) (pixels * GOLDEN));
        while (!BigInteger.valueOf(stride).gcd(BigInteger.valueOf(pixels)).equals(BigInteger.ONE)) {
            stride++;
        }
        return new Places(width, height, (int) Math.min(pixels, most), stride);
    }

    int column(int i) {
        return (int) (pixel(i) % width);
    }

    int row(int i) {
        return (int) (pixel(i) / width);
    }

    private long pixel(int i) {
        return i * stride % ((long) width * height);
    }
}
