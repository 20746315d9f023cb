package cz.paprsek.format.gltf;

import cz.paprsek.image.Image;

/** A number that differs from point to point of a picture, or is the same everywhere. */
final class Channel {
    static final int ALPHA = 24;
    static final int RED = 16;
    static final int GREEN = 8;
    static final int BLUE = 0;

    private final int width;
    private final int height;
    /** 0–255 by rows; none if the number is the same everywhere. */
    private final byte[] samples;
    /** What they are multiplied by, 255 being 1; or the number itself. */
    private final double factor;
    /** From which value on the number is 1, and 0 below; not a number if it counts as it is. */
    private final double cutoff;

    private Channel(int width, int height, byte[] samples, double factor, double cutoff) {
        this.width = width;
        this.height = height;
        this.samples = samples;
        this.factor = factor;
        this.cutoff = cutoff;
    }

    static Channel of(double number) {
        return new Channel(1, 1, new byte[0], number, Double.NaN);
    }

    /** @param shift which channel of the picture */
    static Channel of(Image image, int shift, double factor) {
        byte[] samples = new byte[image.width() * image.height()];
        for (int y = 0, at = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                samples[at++] = (byte) (image.argb(x, y) >> shift);
            }
        }
        return new Channel(image.width(), image.height(), samples, factor, Double.NaN);
    }

    Channel cut(double at) {
        return new Channel(width, height, samples, factor, at);
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** What the samples of the picture are multiplied by. */
    double factor() {
        return factor;
    }

    boolean isEven() {
        return least() == most();
    }

    double least() {
        int least = 255;
        for (byte sample : samples) {
            least = Math.min(least, sample & 0xFF);
        }
        return value(least);
    }

    double most() {
        int most = 0;
        for (byte sample : samples) {
            most = Math.max(most, sample & 0xFF);
        }
        return samples.length == 0 ? value(255) : value(most);
    }

    /** The number at a point of a picture of any size. */
    double at(int x, int y, int ofWidth, int ofHeight) {
        if (samples.length == 0) {
            return value(255);
        }
        int column = (int) ((long) x * width / ofWidth);
        int row = (int) ((long) y * height / ofHeight);
        return value(samples[row * width + column] & 0xFF);
    }

    private double value(int sample) {
        double value = factor * sample / 255;
        return Double.isNaN(cutoff) ? value : value >= cutoff ? 1 : 0;
    }
}
