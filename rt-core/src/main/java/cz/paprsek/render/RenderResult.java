package cz.paprsek.render;

import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import java.util.Objects;
import java.util.Optional;

/**
 * A picture, whole or as far as it got, and what it took.
 *
 * @param layers what else was to be known of its pixels; without planes if nothing was
 * @param certainty how near its pixels are to the truth; empty unless they were judged as paths are, by {@code samples="A..B"}, or for a layer or a mode that tells of it
 */
public record RenderResult(Image image, Layers layers, Stats stats, Outcome outcome, Optional<Certainty> certainty) {
    public RenderResult {
        Objects.requireNonNull(image, "image");
        Objects.requireNonNull(layers, "layers");
        Objects.requireNonNull(stats, "stats");
        Objects.requireNonNull(outcome, "outcome");
        Objects.requireNonNull(certainty, "certainty");
    }

    /**
     * How near the pixels are to the truth, as they are shown, from black as 0 to white as 1, with the confidence that was asked for.
     *
     * @param within the share of pixels that are within the error asked for
     * @param farthest how far any of them may be from the truth
     * @param untrusted the share of pixels of which that cannot be trusted: they are not counted as within the error
     */
    public record Certainty(double within, double farthest, double untrusted) {}

    /** How a render ended. */
    public enum Outcome {
        /** Every pixel is computed. */
        DONE,
        /** The monitor asked to stop; tiles not finished are black. */
        CANCELLED
    }

    /**
     * What a render did.
     *
     * @param primary rays from the eye
     * @param reflected rays mirrored at a surface
     * @param refracted rays that went on through a surface
     * @param shadow rays sent towards a light
     * @param hits primary, reflected and refracted rays that hit something
     * @param buildSeconds time taken to prepare the scene
     * @param traceSeconds time taken to trace the picture
     */
    public record Stats(
            long primary, long reflected, long refracted, long shadow, long hits, double buildSeconds, double traceSeconds) {

        /** Nothing done. */
        public static final Stats NONE = new Stats(0, 0, 0, 0, 0, 0, 0);

        /** Rays of all kinds. */
        public long rays() {
            return primary + reflected + refracted + shadow;
        }
    }
}
