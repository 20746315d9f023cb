package cz.paprsek.image;

import cz.paprsek.math.Require;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
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
        Map<String, String> texts() {
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

    /** How light is fitted to what a screen can show. */
    public enum Tone {
        /** Not at all: light beyond white is white. */
        NONE {
            @Override
            double of(double light) {
                return light;
            }
        },
        /**
         * As photographic film does: shadows a little darker, highlights bent towards white, which is reached at 5.6 times what is white otherwise.
         * Channel by channel.
         *
         * @source Hable, Filmic Tonemapping for Real-time Rendering, SIGGRAPH 2010 course Color Enhancement and Rendering in Film and Game
         *     Production: his curve with his constants, exposure bias 2 and linear white 11.2
         */
        FILMIC {
            @Override
            double of(double light) {
                return Math.min(1, curve(2 * Math.max(0, light)) / curve(11.2));
            }

            private double curve(double x) {
                // Beyond all films, where the quotient of squares would overflow.
                double least = Math.min(x, 1e6);
                double shoulder = 0.15;
                double linear = 0.50;
                double angle = 0.10;
                double toe = 0.20;
                double numerator = 0.02;
                double denominator = 0.30;
                return (least * (shoulder * least + angle * linear) + toe * numerator) / (least * (shoulder * least + linear) + toe * denominator)
                        - numerator / denominator;
            }
        };

        /** The light to show, 1 for white. */
        abstract double of(double light);
    }
}
