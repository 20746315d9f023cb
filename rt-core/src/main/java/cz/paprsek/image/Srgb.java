package cz.paprsek.image;

import cz.paprsek.material.Rgb;

/** Linear light to 8-bit sRGB, exactly rounded, without a power per pixel. */
final class Srgb {
    /** {@code THRESHOLDS[v]}: the least light that rounds to v or more. */
    private static final float[] THRESHOLDS = thresholds();
    /** For each 1/1024 of light, the value at its start: where the search begins. */
    private static final byte[] START = starts();

    private static final float[] LIGHT = lights();

    private Srgb() {}

    /** The light that an sRGB channel of 0–255 stands for. */
    static float light(int channel) {
        return LIGHT[channel];
    }

    /** The sRGB channel, 0–255, nearest to the given light; clamped. Not a number gives 0. */
    static int encode(float light) {
        if (!(light > 0)) {
            return 0;
        }
        if (light >= 1) {
            return 255;
        }
        int value = START[(int) (light * 1024)] & 0xFF;
        while (value < 255 && light >= THRESHOLDS[value + 1]) {
            value++;
        }
        return value;
    }

    private static float[] lights() {
        float[] light = new float[256];
        for (int i = 0; i < light.length; i++) {
            light[i] = (float) Rgb.linear(i);
        }
        return light;
    }

    private static float[] thresholds() {
        float[] least = new float[256];
        for (int v = 1; v < 256; v++) {
            double exact = Rgb.linear(v - 0.5);
            float rounded = (float) exact;
            least[v] = rounded < exact ? Math.nextUp(rounded) : rounded;
        }
        return least;
    }

    private static byte[] starts() {
        byte[] start = new byte[1024];
        int value = 0;
        for (int i = 0; i < start.length; i++) {
            while (value < 255 && i / 1024f >= THRESHOLDS[value + 1]) {
                value++;
            }
            start[i] = (byte) value;
        }
        return start;
    }
}
