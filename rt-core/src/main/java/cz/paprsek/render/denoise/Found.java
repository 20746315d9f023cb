package cz.paprsek.render.denoise;

import java.util.stream.Stream;

/** What several ways have found for each pixel, and how good that seems. */
final class Found {
    /** By ways, halves, channels and pixels: what each half says. */
    final float[][][][] light;
    /** By ways: the square of the error, by what noise would bring, itself with noise. */
    final float[][] error;

    Found(int ways, int width, int height) {
        this(new float[ways][Noisy.HALVES][Noisy.CHANNELS][width * height], new float[ways][width * height]);
    }

    private Found(float[][][][] light, float[][] error) {
        this.light = light;
        this.error = error;
    }

    /** With more ways beside its own. */
    Found and(Found more) {
        return new Found(Stream.concat(Stream.of(light), Stream.of(more.light)).toArray(float[][][][]::new), Stream.concat(Stream.of(error), Stream.of(more.error)).toArray(float[][]::new));
    }
}
