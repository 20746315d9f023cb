package cz.paprsek.render;

import cz.paprsek.image.Image;

/** A picture, whole or as far as it got, and what it took. */
public record RenderResult(Image image, RenderStats stats, Outcome outcome) {

    /** How a render ended. */
    public enum Outcome {
        /** Every pixel is computed. */
        DONE,
        /** The monitor asked to stop; tiles not finished are black. */
        CANCELLED
    }
}
