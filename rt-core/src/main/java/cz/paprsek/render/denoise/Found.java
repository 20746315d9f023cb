package cz.paprsek.render.denoise;

/** What several ways have found for each pixel, and how good that seems. */
final class Found {
    /** By ways, channels and pixels: the mean of what both halves say. */
    final float[][][] light;
    /** By ways: the square of the error, by what noise would bring, itself with noise. */
    final float[][] error;

    Found(int ways, int width, int height) {
        light = new float[ways][Noisy.CHANNELS][width * height];
        error = new float[ways][width * height];
    }
}
