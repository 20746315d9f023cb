package cz.paprsek.render.denoise;

/** What is known of a picture with noise, pixel by pixel, row by row from the top left. Workers fill it each for pixels of its own. */
final class Noisy {
    static final int CHANNELS = 3;

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
        this(width, height, guides, new float[2][CHANNELS][width * height], new float[guides][width * height]);
    }

    /** Of the same light and the same doubts, with what else there is still to be said. */
    Noisy(Noisy same) {
        this(same.width, same.height, same.guides.length, same.light, same.doubts);
    }

    private Noisy(int width, int height, int guides, float[][][] light, float[][] doubts) {
        this.width = width;
        this.height = height;
        this.light = light;
        int pixels = width * height;
        this.spread = new float[CHANNELS][pixels];
        this.guides = new float[guides][pixels];
        this.doubts = doubts;
    }
}
