package cz.paprsek.image;

import cz.paprsek.math.Require;
import java.util.OptionalInt;

/**
 * How a picture is written.
 *
 * @param bits per channel; if none are given, as many as the format usually has, see {@link ImageFormat#depths}
 * @param exposure in stops: each doubles the light
 * @param tone how light is fitted to a screen
 * @param origin what the file tells of where the picture comes from, if its format holds text
 */
public record ImageOptions(OptionalInt bits, double exposure, Tone tone, Origin origin) {
    /** As the picture is, with nothing told of it. */
    public static final ImageOptions DEFAULT = new ImageOptions(OptionalInt.empty(), 0, Tone.NONE, Origin.UNTOLD);

    private static final double MOST_STOPS = 100;

    /** @throws IllegalArgumentException if the exposure is outside ±100 stops */
    public ImageOptions {
        Require.within("exposure", exposure, -MOST_STOPS, MOST_STOPS);
    }

    public ImageOptions withBits(int count) {
        return new ImageOptions(OptionalInt.of(count), exposure, tone, origin);
    }

    public ImageOptions withExposure(double stops) {
        return new ImageOptions(bits, stops, tone, origin);
    }

    public ImageOptions withTone(Tone curve) {
        return new ImageOptions(bits, exposure, curve, origin);
    }

    public ImageOptions withOrigin(Origin told) {
        return new ImageOptions(bits, exposure, tone, told);
    }

    /**
     * The bits per channel that a format is to have.
     *
     * @throws IllegalArgumentException if it cannot have as many
     */
    public int bitsOf(ImageFormat format) {
        int wanted = bits.orElse(format.depths().get(0));
        Require.that(format.depths().contains(wanted), format.extension() + " has " + format.depthsAsText() + " bits per channel, not " + wanted);
        return wanted;
    }

    /** The picture exposed and toned; itself if there is nothing to do. */
    Image develop(Image image) {
        if (exposure == 0 && tone == Tone.NONE) {
            return image;
        }
        double gain = StrictMath.pow(2, exposure);
        Image developed = new Image(image.width(), image.height());
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                developed.set(x, y, tone.of(gain * image.red(x, y)), tone.of(gain * image.green(x, y)), tone.of(gain * image.blue(x, y)));
            }
        }
        return developed;
    }
}
