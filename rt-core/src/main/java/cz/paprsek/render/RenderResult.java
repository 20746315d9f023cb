package cz.paprsek.render;

import cz.paprsek.image.Image;
import java.util.Objects;

/** A picture, whole or as far as it got, and what it took. */
public record RenderResult(Image image, RenderStats stats, Outcome outcome) {
    public RenderResult {
        Objects.requireNonNull(image, "image");
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
