package cz.paprsek.tree;

import java.util.Arrays;

/**
 * Scratch of one worker: a line as a tree of wide nodes asks about boxes, in floats. Relative to the tree's centre and scale, rounded so that
 * no box is missed: where the origin lies is taken as twice, once for the planes crossed first and once for those crossed last. Values of t
 * are compared as integers, see {@link Probe}.
 */
final class WideProbe {
    /** By so many units in the last place t may be wrong on the near and the far side together, rounded up generously. */
    static final int SLACK = 8;
    /** From farther away than so many times the tree's size all boxes are taken as met: floats could not tell. */
    private static final double FAR = 1e30;
    /** More than what rounding to a float changes, relatively. */
    private static final float ROUNDING = 1.2e-7f;
    /** The longest part of a direction whose reciprocal is from 1/{@value} to {@value} is taken as it is. */
    private static final double ORDINARY = 1 << 20;
    /** If it is less than one over 2 to this power, or as much more, all boxes are taken as met. */
    private static final int EXTREME = 500;
    /** From farther away than so many steps of a grid, and with longer reciprocals of a direction in steps, floats could not tell whether a box is met. */
    private static final double FAR_STEPS = 1e10;
    private static final double MOST_STEPS = 1e30;
    private static final int LEAST = upper(1 / ORDINARY);
    private static final int MOST = upper(ORDINARY);

    float nearX;
    float nearY;
    float nearZ;
    float farX;
    float farY;
    float farZ;
    /** Where the origin lies for the lower plane of each axis, and for the upper one, whichever of them is crossed first. */
    float lowX;
    float lowY;
    float lowZ;
    float highX;
    float highY;
    float highZ;
    float rx;
    float ry;
    float rz;
    int begin;
    int end;
    /** Where in a node the planes begin that the line crosses first and last, by axis. */
    int firstX;
    int firstY;
    int firstZ;
    /** What values of t are multiplied by: a power of two. */
    private double scale = 1;

    /** Nodes and leaves to visit, the nearest on top: where the line enters, and in the lower half its name. */
    long[] stack = {};
    int top;
    final int[] lanes = new int[WideNodes.MOST];

    /** Makes room for so many nodes to visit. */
    void reserve(int most) {
        if (stack.length < most) {
            stack = Arrays.copyOf(stack, most);
        }
    }

    /** Takes over the line, as seen in the space of a tree. */
    void set(WideNodes nodes, double ox, double oy, double oz, double reciprocalX, double reciprocalY, double reciprocalZ, double min, double max) {
        int least = Math.min(upper(reciprocalX), Math.min(upper(reciprocalY), upper(reciprocalZ)));
        if (least >= LEAST && least <= MOST) {
            set(nodes, ox, oy, oz, reciprocalX, reciprocalY, reciprocalZ, nodes.scale, min, max);
            return;
        }
        // In the space of something placed very large or small a direction is so short or long that floats hold neither its reciprocals nor t.
        int exponent = (least >> 20) - Double.MAX_EXPONENT;
        if (Math.abs(exponent) > EXTREME) {
            meetAll();
            return;
        }
        double unit = Math.scalb(1.0, -exponent);
        set(nodes, ox, oy, oz, reciprocalX * unit, reciprocalY * unit, reciprocalZ * unit, nodes.scale * unit, min, max);
    }

    private void set(WideNodes nodes, double ox, double oy, double oz, double reciprocalX, double reciprocalY, double reciprocalZ, double unit, double min, double max) {
        scale = unit;
        begin = Math.max(0, order(min));
        end = order(max);
        double x = (ox - nodes.centreX) * nodes.scale;
        double y = (oy - nodes.centreY) * nodes.scale;
        double z = (oz - nodes.centreZ) * nodes.scale;
        if (!(Math.abs(x) + Math.abs(y) + Math.abs(z) < FAR)) {
            meetAll();
            return;
        }
        firstX = reciprocalX < 0 ? 24 : 0;
        firstY = reciprocalY < 0 ? 32 : 8;
        firstZ = reciprocalZ < 0 ? 40 : 16;
        rx = finite(reciprocalX);
        ry = finite(reciprocalY);
        rz = finite(reciprocalZ);
        float widerX = Math.abs((float) x) * ROUNDING;
        float widerY = Math.abs((float) y) * ROUNDING;
        float widerZ = Math.abs((float) z) * ROUNDING;
        lowX = (float) x + widerX;
        lowY = (float) y + widerY;
        lowZ = (float) z + widerZ;
        highX = (float) x - widerX;
        highY = (float) y - widerY;
        highZ = (float) z - widerZ;
        nearX = rx < 0 ? highX : lowX;
        nearY = ry < 0 ? highY : lowY;
        nearZ = rz < 0 ? highZ : lowZ;
        farX = rx < 0 ? lowX : highX;
        farY = ry < 0 ? lowY : highY;
        farZ = rz < 0 ? lowZ : highZ;
        top = 0;
    }

    /**
     * Takes over the line, as seen on the grid of a packed tree. A plane at q is crossed at t = q·r − o·r, of which the second product is rounded once, down for the planes crossed first and up for the others.
     */
    void set(PackedNodes nodes, double ox, double oy, double oz, double reciprocalX, double reciprocalY, double reciprocalZ, double min, double max) {
        int least = Math.min(upper(reciprocalX), Math.min(upper(reciprocalY), upper(reciprocalZ)));
        int exponent = least >= LEAST && least <= MOST ? 0 : (least >> 20) - Double.MAX_EXPONENT;
        double x = (ox - nodes.centreX) * nodes.stepsX;
        double y = (oy - nodes.centreY) * nodes.stepsY;
        double z = (oz - nodes.centreZ) * nodes.stepsZ;
        if (Math.abs(exponent) > EXTREME || !(Math.abs(x) + Math.abs(y) + Math.abs(z) < FAR_STEPS)) {
            meetAll();
            return;
        }
        int width = nodes.width;
        scale = exponent == 0 ? nodes.scale : Math.scalb(nodes.scale, -exponent);
        begin = Math.max(0, order(min));
        end = order(max);
        firstX = reciprocalX < 0 ? 3 * width / 2 : 0;
        firstY = reciprocalY < 0 ? 2 * width : width / 2;
        firstZ = reciprocalZ < 0 ? 5 * width / 2 : width;
        rx = inSteps(reciprocalX * (scale / nodes.stepsX));
        ry = inSteps(reciprocalY * (scale / nodes.stepsY));
        rz = inSteps(reciprocalZ * (scale / nodes.stepsZ));
        double cx = -x * rx;
        double cy = -y * ry;
        double cz = -z * rz;
        double widerX = Math.abs(cx) * ROUNDING;
        double widerY = Math.abs(cy) * ROUNDING;
        double widerZ = Math.abs(cz) * ROUNDING;
        nearX = (float) (cx - widerX);
        nearY = (float) (cy - widerY);
        nearZ = (float) (cz - widerZ);
        farX = (float) (cx + widerX);
        farY = (float) (cy + widerY);
        farZ = (float) (cz + widerZ);
        top = 0;
    }

    private static float inSteps(double r) {
        return (float) (r > MOST_STEPS ? MOST_STEPS : r < -MOST_STEPS ? -MOST_STEPS : r);
    }

    /** Whether all boxes are taken as met. */
    boolean meetsAll() {
        return rx == Float.MIN_VALUE;
    }

    /** Takes note that the line has become shorter. */
    void end(double max) {
        if (!meetsAll()) {
            end = order(max);
        }
    }

    /** Whether the line meets the box of a child of a node of four whose planes begin at {@code at}. */
    boolean enters(float[] planes, int at) {
        int inX = firstX / 2;
        int inY = firstY / 2;
        int inZ = firstZ / 2;
        int in = Math.max(
                Math.max(bits((planes[at + inX] - nearX) * rx), bits((planes[at + inY] - nearY) * ry)),
                Math.max(bits((planes[at + inZ] - nearZ) * rz), begin));
        int out = Math.min(
                Math.min(bits((planes[at + 12 - inX] - farX) * rx), bits((planes[at + 20 - inY] - farY) * ry)),
                Math.min(bits((planes[at + 28 - inZ] - farZ) * rz), end));
        return (in - out - (SLACK + 1) & ~out) < 0;
    }

    static int bits(float t) {
        return Float.floatToRawIntBits(t);
    }

    private int order(double t) {
        return Float.floatToRawIntBits((float) (t * scale));
    }

    /** From everywhere between −1 and 1 to −2 it is less than {@link #SLACK} of the smallest floats, so that all boxes are met. */
    private void meetAll() {
        lowX = lowY = lowZ = highX = highY = highZ = -2;
        nearX = nearY = nearZ = farX = farY = farZ = -2;
        rx = ry = rz = Float.MIN_VALUE;
        firstX = 0;
        firstY = 8;
        firstZ = 16;
        begin = 0;
        // Less than what is made of planes that are no number.
        end = bits(Float.POSITIVE_INFINITY);
        top = 0;
    }

    /** The upper half of a number without its sign: in the order of numbers. */
    private static int upper(double x) {
        return (int) (Double.doubleToRawLongBits(x) >>> 32) & Integer.MAX_VALUE;
    }

    private static float finite(double r) {
        return r > Float.MAX_VALUE ? Float.MAX_VALUE : r < -Float.MAX_VALUE ? -Float.MAX_VALUE : (float) r;
    }
}
