package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Require;
import cz.paprsek.text.Numbers;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.Stream;

/**
 * How a scene wishes to be rendered when the caller does not say otherwise.
 *
 * @param width picture width in pixels, 1–{@value #LARGEST_SIDE}
 * @param height picture height in pixels, 1–{@value #LARGEST_SIDE}
 * @param maxDepth levels of rays, the eye ray being level 1; of paths, how often light is scattered at most; 1–{@value #DEEPEST}
 * @param integrator how light is gathered
 * @param samples rays along each side of a pixel: 1 for one ray through its centre, n for a regular grid of n × n; 1–{@value #MOST_SAMPLES}.
 *     Of paths, how many there are in a pixel; 1–{@value #MOST_PATHS}
 * @param mostSamples 0 for that grid, or number; else a pixel gets samples² random rays, or samples paths, and more, at most mostSamples² or mostSamples,
 *     until its error is as small as it shall be: by the spread of its own rays, whatever is beside it; from samples on
 * @param error how far the value that is shown of a pixel may be from the true one, 1 being from black to white; above 0
 * @param confidence how probable it is to be that close; above 0 and below 1
 * @param filter how a pixel's rays are strewn around its centre
 * @param exposure in stops, each of which doubles the light of the picture as it is shown and written; ±{@value #MOST_STOPS}
 * @param tone how light is fitted to a screen when the picture is shown and written
 * @param fps frames per second, above 0 and at most 1000: of a film, the picture of frame n is that of the time (n − 1)/fps
 * @param shutter for how much of the time from one frame to the next light falls in, 0–1
 */
@Element(name = "render", value = "How the scene wishes to be rendered.")
public record RenderSettings(
        @Attribute(value = Kind.PIXELS, means = "Picture width in pixels", otherwise = "800") int width,
        @Attribute(value = Kind.PIXELS, means = "Picture height in pixels", otherwise = "600") int height,
        @Attribute(value = Kind.DEPTH, means = "Levels of rays, the eye ray being level 1", otherwise = "5") int maxDepth,
        @Attribute(value = Kind.WORD, means = "How light is gathered: whitted follows mirrors, glass and the lights, path all ways that light can come", otherwise = "whitted")
        Integrator integrator,
        @Attribute(value = Kind.SAMPLES, name = "samples", means = "Rays along each side of a pixel: N for a grid of N x N, A..B for A x A random ones and "
                + "more, at most B x B, until the error is small. With the integrator path, the number of paths in a pixel, which is 64 if not given", otherwise = "1") int samples,
        @Attribute(value = Kind.MOST_SAMPLES, inForce = "allowedSamples", name = "samples", means = "") int mostSamples,
        @Attribute(value = Kind.POSITIVE, inForce = "allowedError", means = "With samples A..B, how far the value shown of a pixel may be from the true one; 1 is from black to white",
                otherwise = "0.01") double error,
        @Attribute(value = Kind.CONFIDENCE, inForce = "wantedConfidence", means = "How probable it is to be that close", otherwise = "0.95") double confidence,
        @Attribute(value = Kind.WORD, means = "How a pixel's rays are strewn around its centre", otherwise = "box") PixelFilter filter,
        @Attribute(value = Kind.STOPS, means = "Brightens the picture as it is shown and written; each stop doubles the light", otherwise = "0") double exposure,
        @Attribute(value = Kind.WORD, means = "How light is fitted to a screen: none, or filmic, which bends highlights towards white as film does", otherwise = "none") Tone tone,
        @Attribute(value = Kind.FRAME_RATE, inForce = "ownFps", means = "Pictures a second, if it is rendered as many of them", otherwise = "25") double fps,
        @Attribute(value = Kind.SHARE, inForce = "openShutter", means = "How long light falls in for each of them, as a share of the time from one to the next", otherwise = "0") double shutter) {
    public static final int LARGEST_SIDE = 32_768;
    public static final int DEEPEST = 250;
    public static final int MOST_SAMPLES = 16;
    public static final int MOST_PATHS = 1_000_000;
    /** In a pixel, if nobody says how many. */
    public static final int USUAL_PATHS = 64;
    public static final int MOST_STOPS = 100;
    private static final double USUAL_FPS = 25;
    public static final RenderSettings DEFAULT = new RenderSettings(800, 600, 5, 1);

    public RenderSettings {
        Require.within("render width", width, 1, LARGEST_SIDE);
        Require.within("render height", height, 1, LARGEST_SIDE);
        Require.within("render max-depth", maxDepth, 1, DEEPEST);
        Objects.requireNonNull(integrator, "integrator");
        Require.within("render samples", samples, 1, integrator.mostSamples());
        Require.within("render samples, the most of them,", mostSamples, 0, integrator.mostSamples());
        Require.that(mostSamples == 0 || mostSamples >= samples,
                "render samples must go from the lesser to the greater number, but go from " + samples + " to " + mostSamples);
        Require.positive("render error", error);
        Require.that(confidence > 0 && confidence < 1, "render confidence must be a number above 0 and below 1, but is " + Numbers.text(confidence));
        Objects.requireNonNull(filter, "filter");
        Require.within("render exposure", exposure, -MOST_STOPS, MOST_STOPS);
        Objects.requireNonNull(tone, "tone");
        Require.within("render fps", Require.positive("render fps", fps), 0, Kind.FRAME_RATE.most());
        Require.within("render shutter", shutter, 0, 1);
    }

    /** The frames per second, if they are others than usual. */
    public OptionalDouble ownFps() {
        return fps == USUAL_FPS ? OptionalDouble.empty() : OptionalDouble.of(fps);
    }

    /** The share of the time in which light falls in, if it does not just for a moment. */
    public OptionalDouble openShutter() {
        return shutter > 0 ? OptionalDouble.of(shutter) : OptionalDouble.empty();
    }

    /** The time of a frame, in seconds: the first, whose number is 1, is at 0. */
    public double seconds(double frame) {
        return (frame - 1) / fps;
    }

    /** A regular grid of rays in each pixel. */
    public RenderSettings(int width, int height, int maxDepth, int samples) {
        this(width, height, maxDepth, Integrator.WHITTED, samples, 0, 0.01, 0.95, PixelFilter.BOX, 0, Tone.NONE, USUAL_FPS, 0);
    }

    /** Whether light comes any way it can, rather than by mirrors, glass and straight from the lights. */
    public boolean isPath() {
        return integrator == Integrator.PATH;
    }

    /** Whether each pixel gets as many rays as it needs, rather than a grid of them. */
    public boolean isAdaptive() {
        return mostSamples > 0;
    }

    /** How many rays a pixel gets at most. */
    public int mostRays() {
        int most = Math.max(samples, mostSamples);
        return isPath() ? most : most * most;
    }

    /** The most samples, as they are written, that a pixel gets if it needs them; empty for a grid, whose pixels are not judged. */
    public OptionalInt allowedSamples() {
        return isAdaptive() ? OptionalInt.of(mostSamples) : OptionalInt.empty();
    }

    /** The error by which pixels are judged; empty for a grid. */
    public OptionalDouble allowedError() {
        return isAdaptive() ? OptionalDouble.of(error) : OptionalDouble.empty();
    }

    /** Likewise the confidence. */
    public OptionalDouble wantedConfidence() {
        return isAdaptive() ? OptionalDouble.of(confidence) : OptionalDouble.empty();
    }

    public RenderSettings withSize(int newWidth, int newHeight) {
        return new RenderSettings(newWidth, newHeight, maxDepth, integrator, samples, mostSamples, error, confidence, filter, exposure, tone, fps, shutter);
    }

    public RenderSettings withMaxDepth(int levels) {
        return new RenderSettings(width, height, levels, integrator, samples, mostSamples, error, confidence, filter, exposure, tone, fps, shutter);
    }

    /** With another integrator, and as many samples as that takes if nobody says how many; as it is if that is its own. */
    public RenderSettings withIntegrator(Integrator kind) {
        return kind == integrator ? this : new RenderSettings(width, height, maxDepth, kind, kind.usualSamples(), 0, error, confidence, filter, exposure, tone, fps, shutter);
    }

    /** With a regular grid, or of paths with a number of them. */
    public RenderSettings withSamples(int perSide) {
        return withSamples(perSide, 0);
    }

    /** With random rays, from least² to most² in a pixel, or as many paths; a most of 0 stands for a regular grid, or as many paths as the least. */
    public RenderSettings withSamples(int least, int most) {
        return new RenderSettings(width, height, maxDepth, integrator, least, most, error, confidence, filter, exposure, tone, fps, shutter);
    }

    /**
     * Of paths, with another number in each pixel; if pixels are judged, with another one at most.
     *
     * @throws IllegalArgumentException if these settings are not of paths
     */
    public RenderSettings withMostRays(int paths) {
        Require.that(isPath(), "a most number of rays is of paths");
        return isAdaptive() ? withSamples(Math.min(samples, paths), paths) : withSamples(paths);
    }

    public RenderSettings withError(double target) {
        return new RenderSettings(width, height, maxDepth, integrator, samples, mostSamples, target, confidence, filter, exposure, tone, fps, shutter);
    }

    public RenderSettings withConfidence(double probability) {
        return new RenderSettings(width, height, maxDepth, integrator, samples, mostSamples, error, probability, filter, exposure, tone, fps, shutter);
    }

    public RenderSettings withFilter(PixelFilter kind) {
        return new RenderSettings(width, height, maxDepth, integrator, samples, mostSamples, error, confidence, kind, exposure, tone, fps, shutter);
    }

    public RenderSettings withExposure(double stops) {
        return new RenderSettings(width, height, maxDepth, integrator, samples, mostSamples, error, confidence, filter, stops, tone, fps, shutter);
    }

    public RenderSettings withTone(Tone curve) {
        return new RenderSettings(width, height, maxDepth, integrator, samples, mostSamples, error, confidence, filter, exposure, curve, fps, shutter);
    }

    public RenderSettings withFps(double framesPerSecond) {
        return new RenderSettings(width, height, maxDepth, integrator, samples, mostSamples, error, confidence, filter, exposure, tone, framesPerSecond, shutter);
    }

    public RenderSettings withShutter(double share) {
        return new RenderSettings(width, height, maxDepth, integrator, samples, mostSamples, error, confidence, filter, exposure, tone, fps, share);
    }

    /** Which ways light comes. */
    public enum Integrator {
        /** Straight from the lights, by mirrors and through glass. */
        WHITTED(1, MOST_SAMPLES),
        /** Any way, from surface to surface. */
        PATH(USUAL_PATHS, MOST_PATHS);

        private final int usualSamples;
        private final int mostSamples;

        Integrator(int usualSamples, int mostSamples) {
            this.usualSamples = usualSamples;
            this.mostSamples = mostSamples;
        }

        /** The samples of settings that say none. */
        public int usualSamples() {
            return usualSamples;
        }

        /** The largest number of samples that can be written. */
        public int mostSamples() {
            return mostSamples;
        }

        /** The name as people type it. */
        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }

        /** The integrator of that name, in any case. */
        public static Optional<Integrator> of(String name) {
            Objects.requireNonNull(name, "name");
            return Stream.of(values()).filter(kind -> kind.name().equalsIgnoreCase(name)).findFirst();
        }
    }

    /** From where around its centre a pixel gathers light, and with what weight: what its rays are strewn by. */
    public enum PixelFilter {
        /** The pixel's own square, evenly. */
        BOX,
        /** A pixel to each side, falling to nothing in straight lines. */
        TENT,
        /** A bell curve with a standard deviation of half a pixel, cut off two pixels away. */
        GAUSS,
        /**
         * Two pixels to each side, below nothing in the outer one, which makes edges sharper.
         *
         * @source Mitchell and Netravali, Reconstruction Filters in Computer Graphics, SIGGRAPH 1988, with B = C = ⅓
         */
        MITCHELL;

        /** The name as people type it. */
        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }

        /** The filter of that name, in any case. */
        public static Optional<PixelFilter> of(String name) {
            Objects.requireNonNull(name, "name");
            return Stream.of(values()).filter(filter -> filter.name().equalsIgnoreCase(name)).findFirst();
        }
    }
}
