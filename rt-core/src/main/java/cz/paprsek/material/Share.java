package cz.paprsek.material;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Kind;
import java.util.Objects;

/** How a share depends on the point. */
public sealed interface Share {
    /** The greatest share there is, where {@code even} is the share if it is the same everywhere. */
    double most(double even);

    /** The same everywhere. */
    record Even() implements Share {
        @Override
        public double most(double even) {
            return even;
        }
    }

    /**
     * By what a pattern has at each point. Its colours and pictures are numbers there, not light: 128 of 255 is about one half.
     *
     * @param channel what of a colour is the share
     * @param pattern not of one colour
     */
    record ByPattern(
            @Attribute(value = Kind.WORD, means = "What of a colour is the share: luminance, 0.2126 of red, 0.7152 of green and 0.0722 of blue, or one of them",
                    otherwise = "luminance") ColorChannel channel,
            Pattern pattern) implements Share {
        /** @throws IllegalArgumentException if the pattern has one colour only */
        public ByPattern {
            Objects.requireNonNull(channel, "channel");
            Material.varied(pattern);
        }

        /** By luminance. */
        public ByPattern(Pattern pattern) {
            this(ColorChannel.LUMINANCE, pattern);
        }

        /** That of the pattern's colours; 1 if nobody knows which there are, as in a picture. */
        @Override
        public double most(double even) {
            return pattern.palette().stream().mapToDouble(channel::of).max().orElse(1);
        }

        /** The smallest share there is: that of the pattern's colours; 0 if nobody knows which there are. */
        public double least() {
            return pattern.palette().stream().mapToDouble(channel::of).min().orElse(0);
        }
    }

    /** What of a colour is a number. */
    enum ColorChannel {
        LUMINANCE, RED, GREEN, BLUE;

        /** The number, 0–1, that a colour stands for. */
        public double of(Rgb color) {
            return of(color.red() / 255, color.green() / 255, color.blue() / 255);
        }

        /** A number, 0–1, of three, 0–1. */
        public double of(double red, double green, double blue) {
            return switch (this) {
                case LUMINANCE -> Math.min(1, 0.2126 * red + 0.7152 * green + 0.0722 * blue);
                case RED -> red;
                case GREEN -> green;
                case BLUE -> blue;
            };
        }
    }
}
