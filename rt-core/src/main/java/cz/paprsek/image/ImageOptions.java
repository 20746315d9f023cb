package cz.paprsek.image;

import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Require;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.function.IntBinaryOperator;

/**
 * How a picture is written.
 *
 * @param bits per channel; if none are given, as many as the format usually has, see {@link ImageFormat#depths}
 * @param exposure in stops: each doubles the light
 * @param tone how light is fitted to a screen
 * @param origin what the file tells of where the picture comes from, if its format holds text
 * @param uncompressed whether OpenEXR is not to be compressed, which loses nothing
 */
public record ImageOptions(OptionalInt bits, double exposure, Tone tone, Origin origin, boolean uncompressed) {
    /** As the picture is, with nothing told of it. */
    public static final ImageOptions DEFAULT = new ImageOptions(OptionalInt.empty(), 0, Tone.NONE, Origin.UNTOLD, false);

    static final double MOST_STOPS = 100;

    /** @throws IllegalArgumentException if the exposure is outside ±100 stops */
    public ImageOptions {
        Objects.requireNonNull(bits, "bits");
        Require.within("exposure", exposure, -MOST_STOPS, MOST_STOPS);
        Objects.requireNonNull(tone, "tone");
        Objects.requireNonNull(origin, "origin");
    }

    /**
     * With this exposure and tone.
     *
     * @param stops each doubles the light
     */
    public static ImageOptions shown(double stops, Tone curve) {
        return DEFAULT.withExposure(stops).withTone(curve);
    }

    public ImageOptions withBits(int count) {
        return new ImageOptions(OptionalInt.of(count), exposure, tone, origin, uncompressed);
    }

    public ImageOptions withExposure(double stops) {
        return new ImageOptions(bits, stops, tone, origin, uncompressed);
    }

    public ImageOptions withTone(Tone curve) {
        return new ImageOptions(bits, exposure, curve, origin, uncompressed);
    }

    public ImageOptions withOrigin(Origin told) {
        return new ImageOptions(bits, exposure, tone, told, uncompressed);
    }

    /** As large as it is: an OpenEXR file then need not be unpacked by who reads it. Of other formats there is nothing to choose. */
    public ImageOptions withoutCompression() {
        return new ImageOptions(bits, exposure, tone, origin, true);
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
        Image developed = image.isTransparent() ? Image.ofTransparent(image.width(), image.height()) : new Image(image.width(), image.height());
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                float cover = image.alpha(x, y);
                double red = cover * tone.of(gain * Image.whole(image.red(x, y), cover));
                double green = cover * tone.of(gain * Image.whole(image.green(x, y), cover));
                double blue = cover * tone.of(gain * Image.whole(image.blue(x, y), cover));
                if (image.isTransparent()) {
                    developed.set(x, y, red, green, blue, cover);
                } else {
                    developed.set(x, y, red, green, blue);
                }
            }
        }
        return developed;
    }

    /** The pixels of a picture as a screen shows them, by column and row: exposed and toned, as sRGB, as {@link Image#argb}. */
    public IntBinaryOperator shown(Image image) {
        Objects.requireNonNull(image, "image");
        if (exposure == 0 && tone == Tone.NONE) {
            return image::argb;
        }
        double gain = StrictMath.pow(2, exposure);
        return (x, y) -> {
            float cover = image.alpha(x, y);
            return Math.round(255 * cover) << 24 | shown(gain * Image.whole(image.red(x, y), cover)) << 16
                    | shown(gain * Image.whole(image.green(x, y), cover)) << 8 | shown(gain * Image.whole(image.blue(x, y), cover));
        };
    }

    private int shown(double light) {
        return Srgb.encode((float) tone.of(light));
    }

    /**
     * Where a picture comes from, to be told in its file. Nothing that would differ if it were made again: no clock, no machine, no number of
     * threads. What is empty is left away.
     *
     * @param scene the scene's name
     * @param digest of the scene, by which it can be told from others
     * @param program what computed it, with its version
     * @param settings how it was computed
     */
    public record Origin(String scene, String digest, String program, String settings) {
        /** Tells nothing. */
        public static final Origin UNTOLD = new Origin("", "", "", "");

        public Origin {
            Objects.requireNonNull(scene, "scene");
            Objects.requireNonNull(digest, "digest");
            Objects.requireNonNull(program, "program");
            Objects.requireNonNull(settings, "settings");
        }

        /** What is told, by the words that PNG has for it. */
        public Map<String, String> texts() {
            Map<String, String> texts = new LinkedHashMap<>();
            put(texts, "Title", scene);
            put(texts, "Source", digest);
            put(texts, "Software", program);
            put(texts, "Comment", settings);
            return texts;
        }

        /** As lines of printable ASCII, for comments in heads of files. */
        List<String> lines() {
            List<String> lines = new ArrayList<>();
            texts().forEach((word, text) -> {
                StringBuilder line = new StringBuilder(word + ": ");
                text.codePoints().forEach(c -> line.append(c >= ' ' && c <= '~' ? Character.toString(c) : String.format("\\u%04x", c)));
                lines.add(line.toString());
            });
            return lines;
        }

        private static void put(Map<String, String> texts, String word, String text) {
            if (!text.isEmpty()) {
                texts.put(word, text);
            }
        }
    }
}
