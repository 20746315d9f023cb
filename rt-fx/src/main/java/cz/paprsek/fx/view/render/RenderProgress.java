package cz.paprsek.fx.view.render;

/**
 * How far a render is.
 *
 * @param done tiles finished
 * @param total tiles in all; 0 as long as that is not known
 * @param elapsedSeconds since the beginning
 * @param tracingSeconds of these, until the noise began to be taken out
 * @param rays traced so far, of all kinds
 * @param isEven whether the other tiles may be thought to take as long as those that are finished
 * @param isDenoising whether all is traced, and the noise is being taken out or has been
 */
record RenderProgress(int done, int total, double elapsedSeconds, double tracingSeconds, long rays, boolean isEven, boolean isDenoising) {

    /** 0–1. */
    double share() {
        return total == 0 ? 0 : (double) done / total;
    }

    /** What is left to wait if the other tiles take as long as those that are finished; not a number if there is none. */
    double remainingSeconds() {
        return done == 0 || !isEven ? Double.NaN : elapsedSeconds * (total - done) / done;
    }

    double raysPerSecond() {
        return tracingSeconds > 0 ? rays / tracingSeconds : 0;
    }
}
