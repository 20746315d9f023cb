package cz.paprsek.render;

import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import java.util.Objects;

/**
 * A picture, whole or as far as it got, and what it took.
 *
 * @param layers what else was to be known of its pixels; without planes if nothing was
 */
public record RenderResult(Image image, Layers layers, RenderStats stats, Outcome outcome) {
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
}
