package cz.paprsek.render.mode;

import cz.paprsek.material.Rgb;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** What a picture shows: light, or something to learn from. */
public enum RenderMode {
    /** The light that reaches the eye. */
    SHADED,
    /** Of what is seen, the normal towards the viewer: x as red, y as green, z as blue, −1 as 0 and 1 as 255. */
    NORMALS,
    /** Of what is seen, the distance from the eye: light is near, dark is far, black is nothing. */
    DEPTH,
    /** Of what is seen, the object: a colour for each, by its number in the scene. */
    OBJECTS,
    /** How many rays a pixel took, of all kinds, on a {@linkplain HeatScale#RAYS scale} of colours. */
    RAYS,
    /** How many nodes of the hierarchy those rays visited, each from the root on, on a {@linkplain HeatScale#NODES scale} of colours. */
    NODES,
    /**
     * The share of the lights that reaches what is seen, in their colours; black where all are blocked or behind, and on what shows no light
     * that falls on it, such as a perfect mirror.
     */
    SHADOWS,
    /**
     * How a picture lies on what is seen: ten by ten cells, each with the tenths of its u and v as two digits, redder to the right and
     * greener upwards.
     */
    UV,
    /** How many rays from the eye a pixel took, on a {@linkplain HeatScale#SAMPLES scale} of colours. */
    SAMPLES,
    /**
     * How far the value that is shown may be from the true one, in steps of 255, on a {@linkplain HeatScale#ERROR scale} of colours; where that cannot be trusted,
     * {@linkplain HeatScale#UNTRUSTED a colour of its own}. As numbers: 1 from black to white, and below 0 where that cannot be trusted.
     */
    ERROR;

    /** The scale of a heat map; empty if the picture is none. */
    public Optional<HeatScale> scale() {
        return switch (this) {
            case RAYS -> Optional.of(HeatScale.RAYS);
            case NODES -> Optional.of(HeatScale.NODES);
            case SAMPLES -> Optional.of(HeatScale.SAMPLES);
            case ERROR -> Optional.of(HeatScale.ERROR);
            default -> Optional.empty();
        };
    }

    /** Whether what is shown is a number, one for each pixel. */
    public boolean isNumber() {
        return this == DEPTH || scale().isPresent();
    }

    /** The name as people type it. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The mode of that name, in any case. */
    public static Optional<RenderMode> of(String name) {
        Objects.requireNonNull(name, "name");
        return Stream.of(values()).filter(mode -> mode.name().equalsIgnoreCase(name)).findFirst();
    }

    /**
     * A logarithmic scale of colours for counts, from dark for the smallest to bright for the largest: the same in every picture, so that pictures can be
     * compared.
     *
     * @param smallest what is as dark as can be; anything below is, too
     * @param largest what is as bright as can be; anything above is, too
     */
    public record HeatScale(double smallest, int largest) {
        public static final HeatScale RAYS = new HeatScale(1, 1024);
        public static final HeatScale SAMPLES = new HeatScale(1, 256);
        public static final HeatScale NODES = new HeatScale(1, 16_384);
        /** In steps of 255 from black to white. */
        public static final HeatScale ERROR = new HeatScale(1.0 / 16, 64);
        /** In place of an error that cannot be trusted: no colour of the scale. */
        public static final Rgb UNTRUSTED = new Rgb(0, 190, 230);

        private static final List<Rgb> COLORS = List.of(new Rgb(8, 8, 40), new Rgb(58, 20, 130), new Rgb(165, 35, 125), new Rgb(235, 85, 60),
                new Rgb(250, 175, 50), new Rgb(255, 250, 200));

        /** The colour of a count: black for 0. */
        public Rgb color(double count) {
            return count <= 0 ? Rgb.BLACK : at(StrictMath.log(count / smallest) / StrictMath.log(largest / smallest));
        }

        /** The colour at a place of the scale, from 0 to 1. */
        public Rgb at(double place) {
            double x = Math.min(1, Math.max(0, place)) * (COLORS.size() - 1);
            int below = Math.min((int) x, COLORS.size() - 2);
            return mixed(COLORS.get(below), COLORS.get(below + 1), x - below);
        }

        private static Rgb mixed(Rgb a, Rgb b, double share) {
            return new Rgb(a.red() + share * (b.red() - a.red()), a.green() + share * (b.green() - a.green()), a.blue() + share * (b.blue() - a.blue()));
        }
    }
}
