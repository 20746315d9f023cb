package cz.paprsek.material;

import cz.paprsek.math.Require;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * A colour as people write it: sRGB-encoded, 0–255 per channel, decimals allowed.
 * Arithmetic is done on {@linkplain #linear(double) linear} values.
 */
public record Rgb(double red, double green, double blue) {
    public static final Rgb BLACK = new Rgb(0, 0, 0);
    public static final Rgb WHITE = new Rgb(255, 255, 255);

    /** @throws IllegalArgumentException if a channel is outside 0–255 */
    public Rgb {
        Require.within("red", red, 0, 255);
        Require.within("green", green, 0, 255);
        Require.within("blue", blue, 0, 255);
    }

    /** As that of any record, but at hand, as that of {@link cz.paprsek.math.Vec3}. */
    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof Rgb c && Double.compare(red, c.red) == 0 && Double.compare(green, c.green) == 0 && Double.compare(blue, c.blue) == 0;
    }

    @Override
    public int hashCode() {
        return 31 * (31 * Double.hashCode(red) + Double.hashCode(green)) + Double.hashCode(blue);
    }

    /** A grey of equal channels. */
    public static Rgb grey(double level) {
        return new Rgb(level, level, level);
    }

    /** The colour with the given linear channels, each 0–1. */
    public static Rgb ofLinear(double red, double green, double blue) {
        return new Rgb(encoded(red), encoded(green), encoded(blue));
    }

    public double linearRed() {
        return linear(red);
    }

    public double linearGreen() {
        return linear(green);
    }

    public double linearBlue() {
        return linear(blue);
    }

    /**
     * Linear light, 0–1, of an sRGB channel 0–255.
     *
     * @source IEC 61966-2-1:1999
     */
    public static double linear(double channel) {
        double v = channel / 255;
        return v <= 0.04045 ? v / 12.92 : StrictMath.pow((v + 0.055) / 1.055, 2.4);
    }

    /**
     * The sRGB channel 0–255 of linear light 0–1.
     *
     * @source IEC 61966-2-1:1999
     */
    public static double encoded(double light) {
        double v = light <= 0.0031308 ? light * 12.92 : 1.055 * StrictMath.pow(light, 1 / 2.4) - 0.055;
        // The sum comes a step too low where light is white, as it is most often.
        return light == 1 ? 255 : v * 255;
    }

    /** How light is fitted to what a screen can show. */
    public enum Tone {
        /** Not at all: light beyond white is white. */
        NONE {
            @Override
            public double of(double light) {
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
            public double of(double light) {
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

        /** The light to show of a channel, linear, 1 for white. */
        public abstract double of(double light);

        /** The name as people type it. */
        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }

        /** The curve of that name, in any case. */
        public static Optional<Tone> of(String name) {
            Objects.requireNonNull(name, "name");
            return Stream.of(values()).filter(tone -> tone.name().equalsIgnoreCase(name)).findFirst();
        }
    }
}
