package cz.paprsek.tree;

/**
 * Scratch of one worker: all lines o + t·d from one point o, or from anywhere in a box, with d anywhere between two corners, up to t = 1 or without
 * end. Tells by interval arithmetic which boxes none of them can meet.
 *
 * @source Boulos et al., Geometric and Arithmetic Culling Methods for Entire Ray Packets, 2006
 */
public final class Bundle {
    /** What is not larger has no reciprocal worth having: it bounds nothing. */
    private static final double SMALL = 1e-300;
    /** More than rounding does to a product with a reciprocal, relative to it. */
    private static final double ROUNDING = 1e-15;

    private double fromX;
    private double fromY;
    private double fromZ;
    private double toX;
    private double toY;
    private double toZ;
    private double lowX;
    private double lowY;
    private double lowZ;
    private double highX;
    private double highY;
    private double highZ;
    /** By what the distance of a plane is multiplied for the t at which it is reached: the reciprocals of these, if they have any worth having. */
    private double overLowX;
    private double overLowY;
    private double overLowZ;
    private double overHighX;
    private double overHighY;
    private double overHighZ;
    private double end;
    /** Around all its lines, if they have no end and it is known. */
    private final Frustum frustum = new Frustum();
    private boolean hasFrustum;
    private int corners;

    /** Starts an empty bundle from a point; its lines have no end. */
    public void start(double x, double y, double z) {
        start(x, y, z, x, y, z);
    }

    /** Starts an empty bundle from all points of a box; its lines have no end. */
    public void start(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
        fromX = minX;
        fromY = minY;
        fromZ = minZ;
        toX = maxX;
        toY = maxY;
        toZ = maxZ;
        end = Double.POSITIVE_INFINITY;
        hasFrustum = false;
        corners = 0;
        lowX = Double.POSITIVE_INFINITY;
        lowY = Double.POSITIVE_INFINITY;
        lowZ = Double.POSITIVE_INFINITY;
        highX = Double.NEGATIVE_INFINITY;
        highY = Double.NEGATIVE_INFINITY;
        highZ = Double.NEGATIVE_INFINITY;
    }

    /** Makes this the bundle of the lines from a point, to wherever the lines of another, which start at the origin, end at t = 1. */
    public void lead(double x, double y, double z, Bundle ends) {
        start(x, y, z);
        lowX = ends.lowX - x;
        lowY = ends.lowY - y;
        lowZ = ends.lowZ - z;
        highX = ends.highX - x;
        highY = ends.highY - y;
        highZ = ends.highZ - z;
    }

    /** A length that no d is longer than: at most √3 times as long as the longest can be. */
    public double longest() {
        return Math.max(Math.abs(lowX), Math.abs(highX)) + Math.max(Math.abs(lowY), Math.abs(highY)) + Math.max(Math.abs(lowZ), Math.abs(highZ));
    }

    /** Adds the next of four directions, one beside the other round about, and all between them. */
    public void addCorner(double dx, double dy, double dz) {
        add(dx, dy, dz);
        frustum.corner(corners++, dx, dy, dz);
        if (corners == Frustum.SIDES) {
            hasFrustum = frustum.close(fromX, fromY, fromZ);
        }
    }

    /** Whether it has no lines but those that have been added between four. */
    public boolean hasFrustum() {
        return hasFrustum;
    }

    /** What lies between four of its directions, if it has such. */
    public Frustum frustum() {
        return frustum;
    }

    /** Widens the bundle to hold a direction. */
    public void add(double dx, double dy, double dz) {
        // Not Math.min: a comparison that mostly goes one way costs next to nothing, and this is done for every hit.
        if (dx < lowX) {
            lowX = dx;
        }
        if (dy < lowY) {
            lowY = dy;
        }
        if (dz < lowZ) {
            lowZ = dz;
        }
        if (dx > highX) {
            highX = dx;
        }
        if (dy > highY) {
            highY = dy;
        }
        if (dz > highZ) {
            highZ = dz;
        }
    }

    /** Cuts all lines at t = {@code atMost}. */
    public void end(double atMost) {
        end = atMost;
    }

    /** A length that no d is shorter than; a little below the exact one, so that rounding does not matter. To be called before boxes are asked about. */
    double shortest() {
        overLowX = -over(-lowX);
        overLowY = -over(-lowY);
        overLowZ = -over(-lowZ);
        overHighX = over(highX);
        overHighY = over(highY);
        overHighZ = over(highZ);
        double x = Math.max(0, Math.max(lowX, -highX));
        double y = Math.max(0, Math.max(lowY, -highY));
        double z = Math.max(0, Math.max(lowZ, -highZ));
        return (1 - 1e-12) * Math.sqrt(x * x + y * y + z * z);
    }

    /** Of the most that lines go one way for each t; of next to nothing what says that it is reached at any time, and of nothing, at none. */
    private static double over(double d) {
        return Math.abs(d) > SMALL ? 1 / d : d > 0 ? Double.MIN_NORMAL : Double.MAX_VALUE;
    }

    /** A t before which no line meets the box whose six numbers start at b; infinite if none does at all. */
    double enter(double[] boxes, int b) {
        return enter(boxes[b], boxes[b + 1], boxes[b + 2], boxes[b + 3], boxes[b + 4], boxes[b + 5]);
    }

    double enter(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
        double pX = minX - toX;
        double qX = maxX - fromX;
        double pY = minY - toY;
        double qY = maxY - fromY;
        double pZ = minZ - toZ;
        double qZ = maxZ - fromZ;
        double near = Math.max(Math.max(near(pX, qX, lowX, highX, overLowX, overHighX), near(pY, qY, lowY, highY, overLowY, overHighY)),
                Math.max(near(pZ, qZ, lowZ, highZ, overLowZ, overHighZ), 0));
        double far = Math.min(Math.min(far(pX, qX, lowX, highX, overLowX, overHighX), far(pY, qY, lowY, highY, overLowY, overHighY)),
                Math.min(far(pZ, qZ, lowZ, highZ, overLowZ, overHighZ), end));
        double soon = near * (1 - ROUNDING);
        return soon <= far * (1 + ROUNDING) ? soon : Double.POSITIVE_INFINITY;
    }

    /** The least t that is not negative at which some d in [low, high] has p ≤ t·d ≤ q, or anything less. Which way lines go is the same for all boxes, and so foretold. */
    private static double near(double p, double q, double low, double high, double overLow, double overHigh) {
        return low > SMALL ? p * overHigh : high < -SMALL ? q * overLow : Math.max(p * overHigh, q * overLow);
    }

    /** The greatest such t; below 0 if there is none. */
    private static double far(double p, double q, double low, double high, double overLow, double overHigh) {
        return low > SMALL ? q * overLow : high < -SMALL ? p * overHigh : Double.POSITIVE_INFINITY;
    }
}
