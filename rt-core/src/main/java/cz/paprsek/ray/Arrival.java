package cz.paprsek.ray;

/** Scratch of one worker: where a light is looked for from a point, and what arrives of it if nothing stands in the way. */
public final class Arrival {
    /** The direction to the light, of length 1, world space. */
    public double x;
    public double y;
    public double z;
    /** How far away it is, scene units; infinite for a sun. */
    public double distance;
    /** The light, linear. */
    public double red;
    public double green;
    public double blue;

    /** Turns to a point of the world, where it ends. If both are in one place, as far as numbers tell, the way has no direction: all of it is 0. */
    public void towards(Hit from, double pointX, double pointY, double pointZ) {
        double lx = pointX - from.px;
        double ly = pointY - from.py;
        double lz = pointZ - from.pz;
        double length = Math.sqrt(lx * lx + ly * ly + lz * lz);
        double k = length > 0 ? 1 / length : 0;
        x = lx * k;
        y = ly * k;
        z = lz * k;
        distance = length;
    }

    /** Turns in a direction of length 1, without end. */
    public void along(double directionX, double directionY, double directionZ) {
        x = directionX;
        y = directionY;
        z = directionZ;
        distance = Double.POSITIVE_INFINITY;
    }

    /** Sets the light that arrives, linear. */
    public void light(double r, double g, double b) {
        red = r;
        green = g;
        blue = b;
    }
}
