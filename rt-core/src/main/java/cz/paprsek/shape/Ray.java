package cz.paprsek.shape;

import cz.paprsek.math.Bounds;

/**
 * A ray in world space and what it has hit so far. Scratch: the one mutable object of the hot path, owned by one worker.
 * A hit counts if min &lt; t &lt; max; each accepted hit lowers max.
 */
public final class Ray {
    /** Hits nearer than this times {@link #scale} to where a ray leaves a surface are that surface again. */
    public static final double OFFSET = 1e-9;

    public double ox;
    public double oy;
    public double oz;
    /** Direction, of length 1. */
    public double dx;
    public double dy;
    public double dz;
    /** Reciprocal direction, always finite: 0 · infinity is NaN, and in Java a NaN wins every min and max. */
    public double rx;
    public double ry;
    public double rz;
    /** The size of the numbers that led to the origin: what its rounding errors are relative to. */
    public double scale;
    public double min;
    public double max;
    /** The {@linkplain Parts part} hit, or −1. */
    public int part;
    /** Which face of the part was hit, the part's own numbering; the complement {@code ~face} if an odd number of CSG operations flipped it. */
    public int face;

    /** The stretch of the ray that a convex body was last found to cover, and the faces at its ends. */
    double enter;
    double leave;
    int enterFace;
    int leaveFace;

    final Line local = new Line();
    final double[] breaks = new double[3];
    final Spans spans;

    public Ray(Spans spans) {
        this.spans = spans;
    }

    /** Starts a ray from the eye: nothing hit yet, and nothing too near or too far. */
    public void start(double x, double y, double z, double directionX, double directionY, double directionZ) {
        double size = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        start(x, y, z, directionX, directionY, directionZ, size, Double.POSITIVE_INFINITY);
        min = 0;
    }

    /**
     * Starts a ray from a surface: nothing hit yet.
     *
     * @param size the largest number that led to the origin, coordinates and distance travelled
     * @param end where the ray ends; exclusive
     */
    public void start(double x, double y, double z, double directionX, double directionY, double directionZ, double size, double end) {
        ox = x;
        oy = y;
        oz = z;
        dx = directionX;
        dy = directionY;
        dz = directionZ;
        rx = reciprocal(directionX);
        ry = reciprocal(directionY);
        rz = reciprocal(directionZ);
        scale = size;
        min = OFFSET * size;
        max = end;
        part = -1;
    }

    /** Takes a hit that is known to lie between min and max. */
    void accept(double t, int hitPart, int hitFace) {
        max = t;
        part = hitPart;
        face = hitFace;
    }

    /** Whether the part of the ray between min and max meets the box. */
    public boolean meets(Bounds box) {
        double x0 = (box.minX() - ox) * rx;
        double x1 = (box.maxX() - ox) * rx;
        double y0 = (box.minY() - oy) * ry;
        double y1 = (box.maxY() - oy) * ry;
        double z0 = (box.minZ() - oz) * rz;
        double z1 = (box.maxZ() - oz) * rz;
        double near = Math.max(Math.max(Math.min(x0, x1), Math.min(y0, y1)), Math.max(Math.min(z0, z1), min));
        double far = Math.min(Math.min(Math.max(x0, x1), Math.max(y0, y1)), Math.min(Math.max(z0, z1), max));
        return near <= far;
    }

    private static double reciprocal(double d) {
        double r = 1 / d;
        return Double.isInfinite(r) ? Math.copySign(Double.MAX_VALUE, d) : r;
    }
}
