package cz.paprsek.render;

import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import java.util.Objects;

/**
 * A picture, whole or as far as it got, and what it took.
 *
 * @param layers what else was to be known of its pixels; without planes if nothing was
 */
public record RenderResult(Image image, Layers layers, Stats stats, Outcome outcome) {
    public RenderResult {
        Objects.requireNonNull(image, "image");
        Objects.requireNonNull(layers, "layers");
        Objects.requireNonNull(stats, "stats");
        Objects.requireNonNull(outcome, "outcome");
    }

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
