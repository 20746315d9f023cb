package cz.paprsek.render.denoise;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** What is known of a picture with noise, pixel by pixel, row by row from the top left. Workers fill it each for pixels of its own. */
final class Noisy {
    static final int CHANNELS = 3;
    static final int HALVES = 2;

    final int width;
    final int height;
    /** The light that each half of the paths has brought. */
    final float[][][] light;
    /** The variance of either half. */
    final float[][] spread;
    /** What guides: the mean of both halves, and its variance. */
    final float[][] guides;
    /** As of what they were found, not calmed. */
    final float[][] doubts;

    Noisy(int width, int height, int guides) {
        this(width, height, guides, new float[HALVES][CHANNELS][width * height], new float[guides][width * height]);
    }

    /** Of the same light and the same doubts, with what else there is still to be said. */
    Noisy(Noisy same) {
        this(same.width, same.height, same.guides.length, same.light, same.doubts);
    }

    private Noisy(int width, int height, int guides, float[][][] light, float[][] doubts) {
        this(width, height, light, new float[CHANNELS][width * height], new float[guides][width * height], doubts);
    }

    /** What was {@linkplain #planes() told}. */
    Noisy(int width, int height, int guides, List<float[]> told) {
        this(width, height, new float[][][] {some(told, 0, CHANNELS), some(told, CHANNELS, CHANNELS)}, some(told, 2 * CHANNELS, CHANNELS),
                some(told, 3 * CHANNELS, guides), some(told, 3 * CHANNELS + guides, guides));
    }

    private Noisy(int width, int height, float[][][] light, float[][] spread, float[][] guides, float[][] doubts) {
        this.width = width;
        this.height = height;
        this.light = light;
        this.spread = spread;
        this.guides = guides;
        this.doubts = doubts;
    }

    /** @param halves what each half says of a pixel, by channels */
    void setLight(int x, int y, double[][] halves) {
        for (int half = 0; half < HALVES; half++) {
            for (int channel = 0; channel < CHANNELS; channel++) {
                light[half][channel][y * width + x] = (float) halves[half][channel];
            }
        }
    }

    private static float[][] some(List<float[]> planes, int from, int count) {
        return planes.subList(from, from + count).toArray(float[][]::new);
    }

    /** All of it, plane by plane: light of both halves, their spread, what guides, its doubts. */
    List<float[]> planes() {
        return Stream.of(light[0], light[1], spread, guides, doubts).flatMap(Arrays::stream).toList();
    }

    /** How many those are. */
    static int planes(int guides) {
        return 3 * CHANNELS + 2 * guides;
    }
}
