package cz.paprsek.render.eye;

import cz.paprsek.render.lanes.Vec3s;

/**
 * Scratch of one worker: places of a picture and the directions of the rays through them, side by side. The JVM makes vectors of a plain loop over
 * these, while a root and a quotient for each ray by itself are waited for.
 */
public final class Views {
    /** In pixels from the top left corner of the picture. */
    public double[] x = {};
    public double[] y = {};
    /** Places, in parts of the picture from its middle. */
    double[] u = {};
    double[] v = {};
    /** Of length 1. */
    final Vec3s directions = new Vec3s();
    double[] lengths = {};

    /** Makes room for so many. */
    public void reserve(int count) {
        if (x.length < count) {
            x = new double[count];
            y = new double[count];
            u = new double[count];
            v = new double[count];
            directions.reserve(count);
            lengths = new double[count];
        }
    }
}
