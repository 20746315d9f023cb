package cz.paprsek.render.light;

/** Scratch of one worker: where a light is looked for from a point. */
public final class Arrival {
    /** The direction to the light, of length 1, world space. */
    public double x;
    public double y;
    public double z;
    /** How far away it is, scene units. */
    public double distance;
}
