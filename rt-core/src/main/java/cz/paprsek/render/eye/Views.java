package cz.paprsek.render.eye;

/**
 * Scratch of one worker: places of a picture and the directions of the rays through them, side by side. The JVM makes vectors of a plain loop over
 * these, while a root and a quotient for each ray by itself are waited for.
 */
public final class Views {
    /** In pixels from the top left corner of the picture. */
    public double[] x = {};
    public double[] y = {};
    /** Of length 1. */
    double[] dx = {};
    double[] dy = {};
    double[] dz = {};

    /** Makes room for so many. */
    public void reserve(int count) {
        if (x.length < count) {
            x = new double[count];
            y = new double[count];
            dx = new double[count];
            dy = new double[count];
            dz = new double[count];
        }
    }
}
