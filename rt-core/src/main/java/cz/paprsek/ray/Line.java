package cz.paprsek.ray;

/** Scratch of one worker: a line o + t·d in the space of a shape. */
public final class Line {
    /** Where it starts, t = 0. */
    public double ox;
    public double oy;
    public double oz;
    /** Its direction, of any length but 0. */
    public double dx;
    public double dy;
    public double dz;
}
