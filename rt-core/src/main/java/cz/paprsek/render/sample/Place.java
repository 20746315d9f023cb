package cz.paprsek.render.sample;

/** Scratch of one worker: where a sample's ray goes through its pixel. */
public final class Place {
    /** In pixels from the pixel's left edge; wide filters reach beyond it. */
    public double x;
    /** Likewise from its top. */
    public double y;
    /** Whether the filter weighs what is seen there negatively. */
    public boolean isNegative;
}
