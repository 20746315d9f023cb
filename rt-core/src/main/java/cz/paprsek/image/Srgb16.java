package cz.paprsek.image;

import cz.paprsek.material.Rgb;

/** Linear light to 16-bit sRGB, exactly rounded, without a power per pixel; what {@link Srgb} is for eight bits. */
final class Srgb16 {
    private static final int LAST = 65_535;
    /** {@code THRESHOLDS[v]}: the least light that rounds to v or more. */
    private static final float[] THRESHOLDS = thresholds();
    private static final int CELLS = 1 << 16;
    /** For each of the cells between 0 and 1, the value at its start: where the search begins. */
    private static final char[] START = starts();

    private Srgb16() {}

    /** The sRGB channel, 0–65535, nearest to the given light; clamped. Not a number gives 0. */
    static int encode(float light) {
        if (!(light > 0)) {
            return 0;
        }
        if (light >= 1) {
            return LAST;
        }
        int value = START[(int) (light * CELLS)];
        while (value < LAST && light >= THRESHOLDS[value + 1]) {
            value++;
        }
        return value;
    }

    private static float[] thresholds() {
        float[] least = new float[LAST + 1];
        for (int v = 1; v <= LAST; v++) {
            double exact = Rgb.linear((v - 0.5) / LAST * 255);
            float rounded = (float) exact;
            least[v] = rounded < exact ? Math.nextUp(rounded) : rounded;
        }
        return least;
    }

    private static char[] starts() {
        char[] start = new char[CELLS];
        int value = 0;
        for (int i = 0; i < start.length; i++) {
            while (value < LAST && i / (float) CELLS >= THRESHOLDS[value + 1]) {
                value++;
            }
            start[i] = (char) value;
        }
        return start;
    }
}
