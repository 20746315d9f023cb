package cz.paprsek.tree;

/**
 * Scratch of one worker: a line as the tree asks about boxes.
 *
 * <p>Values of t are compared as the upper halves of doubles, taken as integers: the JVM makes two instructions of the maximum of
 * integers, but eleven, three of them slow, of that of doubles. For numbers not below 0 the order is the same, only coarser, which a
 * + 1 on the far side makes up for. A t below 0 becomes a negative integer, of wrong order among its kind, but below where every line
 * starts, which is all that matters.
 */
final class Probe {
    /** The answer of {@link #enter} when the line does not meet the box: beyond every t. */
    static final int MISS = Integer.MAX_VALUE;

    private double ox;
    private double oy;
    private double oz;
    private double rx;
    private double ry;
    private double rz;
    private int begin;
    private int end;
    /** Which of a box's six numbers are the planes that the line crosses first and last. */
    private int firstX;
    private int firstY;
    private int firstZ;
    private int lastX;
    private int lastY;
    private int lastZ;

    void set(double originX, double originY, double originZ, double reciprocalX, double reciprocalY, double reciprocalZ, double min, double max) {
        ox = originX;
        oy = originY;
        oz = originZ;
        rx = reciprocalX;
        ry = reciprocalY;
        rz = reciprocalZ;
        begin = order(min);
        end = order(max);
        firstX = rx < 0 ? 3 : 0;
        firstY = ry < 0 ? 4 : 1;
        firstZ = rz < 0 ? 5 : 2;
        lastX = 3 - firstX;
        lastY = 5 - firstY;
        lastZ = 7 - firstZ;
    }

    /** Takes note that the line has become shorter. */
    void end(double max) {
        end = order(max);
    }

    /** Whether a box entered at {@code near} is still within reach. */
    boolean reaches(int near) {
        return near <= end;
    }

    /** Where the line enters the box whose six numbers start at b; {@link #MISS} if it does not between its min and max. */
    int enter(double[] boxes, int b) {
        int near = Math.max(
                Math.max(order((boxes[b + firstX] - ox) * rx), order((boxes[b + firstY] - oy) * ry)),
                Math.max(order((boxes[b + firstZ] - oz) * rz), begin));
        int far = Math.min(
                Math.min(order((boxes[b + lastX] - ox) * rx), order((boxes[b + lastY] - oy) * ry)),
                Math.min(order((boxes[b + lastZ] - oz) * rz), end));
        return near <= far + 1 ? near : MISS;
    }

    private static int order(double t) {
        return (int) (Double.doubleToRawLongBits(t) >>> 32);
    }
}
