package cz.paprsek.render;

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
public record RenderStats(
        long primary, long reflected, long refracted, long shadow, long hits, double buildSeconds, double traceSeconds) {

    /** Nothing done. */
    public static final RenderStats NONE = new RenderStats(0, 0, 0, 0, 0, 0, 0);

    /** Rays of all kinds. */
    public long rays() {
        return primary + reflected + refracted + shadow;
    }
}
