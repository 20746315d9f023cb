package cz.paprsek.tree;

import java.util.Arrays;

/**
 * Scratch of one worker: what lies between four planes through one point, from which lines start that stay within them. Tells which boxes and balls
 * none of them can meet: more exactly, and sooner, than intervals of directions do.
 */
public final class Frustum {
    static final int SIDES = 4;
    /** More than rounding does, relative to the numbers it is done to: in doubles, to normals as well, and in floats. */
    private static final double ROUNDING = 1e-10;
    private static final double ROUNDING_OF_FLOATS = 1e-6;
    /** Neighbouring corners with a smaller angle in between, in radians, have no plane worth having. */
    private static final double NARROW = 1e-5;
    /** From farther away, in the space of a tree, floats tell nothing. */
    private static final double FAR = 1e30;

    /** x y z of the directions between which it is. */
    private final double[] corners = new double[3 * SIDES];
    private double ox;
    private double oy;
    private double oz;
    private double size;
    /** The normals of the sides, of length 1, inwards. */
    private final double[] nx = new double[SIDES];
    private final double[] ny = new double[SIDES];
    private final double[] nz = new double[SIDES];
    /** A direction in the middle, of length 1. */
    private double axisX;
    private double axisY;
    private double axisZ;

    /** The sides in the space of a tree, and where in a node the numbers begin of the corners of boxes that lie farthest inwards. */
    final float[] x = new float[SIDES];
    final float[] y = new float[SIDES];
    final float[] z = new float[SIDES];
    final float[] w = new float[SIDES];
    final int[] atX = new int[SIDES];
    final int[] atY = new int[SIDES];
    final int[] atZ = new int[SIDES];
    /** The axis, and where the corners begin that are the first along it. */
    private double alongX;
    private double alongY;
    private double alongZ;
    private double along;
    private int firstX;
    private int firstY;
    private int firstZ;

    /** The sides as a binary tree asks about them, each as x y z of its normal and what is added, and which of a box's six numbers are the corner that lies farthest inwards. */
    private final double[] sides = new double[4 * SIDES];
    private final int[] inmost = new int[3 * SIDES];

    /** Where the boxes begin that are to be visited, the nearest on top, and a t for each before which no line meets it. */
    int[] box = {};
    double[] near = {};

    /** Sets one of four directions, of any length. */
    void corner(int number, double dx, double dy, double dz) {
        corners[3 * number] = dx;
        corners[3 * number + 1] = dy;
        corners[3 * number + 2] = dz;
    }

    /** Puts it around all lines from a point between its corners; false if they are too near to each other. */
    boolean close(double px, double py, double pz) {
        ox = px;
        oy = py;
        oz = pz;
        size = Math.abs(px) + Math.abs(py) + Math.abs(pz);
        double sumX = corners[0] + corners[3] + corners[6] + corners[9];
        double sumY = corners[1] + corners[4] + corners[7] + corners[10];
        double sumZ = corners[2] + corners[5] + corners[8] + corners[11];
        double k = 1 / Math.sqrt(sumX * sumX + sumY * sumY + sumZ * sumZ);
        axisX = k * sumX;
        axisY = k * sumY;
        axisZ = k * sumZ;
        boolean isWide = true;
        for (int i = 0; i < SIDES; i++) {
            int a = 3 * i;
            int b = 3 * ((i + 1) % SIDES);
            double crossX = corners[a + 1] * corners[b + 2] - corners[a + 2] * corners[b + 1];
            double crossY = corners[a + 2] * corners[b] - corners[a] * corners[b + 2];
            double crossZ = corners[a] * corners[b + 1] - corners[a + 1] * corners[b];
            double length = Math.sqrt(crossX * crossX + crossY * crossY + crossZ * crossZ);
            double inwards = crossX * axisX + crossY * axisY + crossZ * axisZ;
            isWide &= length * length > NARROW * NARROW * squared(a) * squared(b) && Math.abs(inwards) > NARROW * length;
            double unit = (inwards < 0 ? -1 : 1) / length;
            nx[i] = unit * crossX;
            ny[i] = unit * crossY;
            nz[i] = unit * crossZ;
        }
        return isWide;
    }

    private double squared(int at) {
        return corners[at] * corners[at] + corners[at + 1] * corners[at + 1] + corners[at + 2] * corners[at + 2];
    }

    /** Whether it reaches into a ball of a squared radius, or nearly. */
    public boolean meetsBall(double x, double y, double z, double r2) {
        double lx = x - ox;
        double ly = y - oy;
        double lz = z - oz;
        double least = Math.min(Math.min(nx[0] * lx + ny[0] * ly + nz[0] * lz, nx[1] * lx + ny[1] * ly + nz[1] * lz),
                Math.min(nx[2] * lx + ny[2] * ly + nz[2] * lz, nx[3] * lx + ny[3] * ly + nz[3] * lz));
        return !(least < -Math.sqrt(r2) - ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(z) + size));
    }

    /**
     * Makes ready to ask about boxes of a tree.
     *
     * @param upper after so many numbers the upper ends of an axis begin; a third of that is from one axis to the next
     * @return false if they are to be asked about otherwise
     */
    boolean aim(WideNodes nodes, int upper) {
        double unit = 1 / nodes.scale;
        double mx = (nodes.centreX - ox) * nodes.scale;
        double my = (nodes.centreY - oy) * nodes.scale;
        double mz = (nodes.centreZ - oz) * nodes.scale;
        double far = Math.abs(mx) + Math.abs(my) + Math.abs(mz);
        if (!(far < FAR)) {
            return false;
        }
        for (int i = 0; i < SIDES; i++) {
            x[i] = (float) nx[i];
            y[i] = (float) ny[i];
            z[i] = (float) nz[i];
            w[i] = (float) (nx[i] * mx + ny[i] * my + nz[i] * mz + ROUNDING_OF_FLOATS * (4 + far));
            atX[i] = nx[i] > 0 ? upper : 0;
            atY[i] = upper / 3 + (ny[i] > 0 ? upper : 0);
            atZ[i] = upper / 3 * 2 + (nz[i] > 0 ? upper : 0);
        }
        firstX = axisX > 0 ? 0 : upper;
        firstY = upper / 3 + (axisY > 0 ? 0 : upper);
        firstZ = upper / 3 * 2 + (axisZ > 0 ? 0 : upper);
        alongX = axisX * unit;
        alongY = axisY * unit;
        alongZ = axisZ * unit;
        along = (axisX * mx + axisY * my + axisZ * mz - ROUNDING * (4 + far)) * unit;
        reserve(nodes.mostToVisit());
        return true;
    }

    /**
     * Makes ready to ask about boxes in doubles, six numbers each.
     *
     * @param largest no number of a box is larger
     * @param most how many are ever left to visit
     */
    void aim(double largest, int most) {
        double slack = ROUNDING * (3 * largest + size);
        for (int i = 0; i < SIDES; i++) {
            sides[4 * i] = nx[i];
            sides[4 * i + 1] = ny[i];
            sides[4 * i + 2] = nz[i];
            sides[4 * i + 3] = slack - (nx[i] * ox + ny[i] * oy + nz[i] * oz);
            inmost[3 * i] = nx[i] > 0 ? 3 : 0;
            inmost[3 * i + 1] = ny[i] > 0 ? 4 : 1;
            inmost[3 * i + 2] = nz[i] > 0 ? 5 : 2;
        }
        firstX = axisX > 0 ? 0 : 3;
        firstY = axisY > 0 ? 1 : 4;
        firstZ = axisZ > 0 ? 2 : 5;
        along = -(axisX * ox + axisY * oy + axisZ * oz) - slack;
        reserve(most);
    }

    /** Whether it reaches into the box whose six numbers start at b, or nearly. */
    boolean meets(double[] boxes, int b) {
        double[] s = sides;
        int[] at = inmost;
        double first = s[0] * boxes[b + at[0]] + s[1] * boxes[b + at[1]] + s[2] * boxes[b + at[2]] + s[3];
        double second = s[4] * boxes[b + at[3]] + s[5] * boxes[b + at[4]] + s[6] * boxes[b + at[5]] + s[7];
        double third = s[8] * boxes[b + at[6]] + s[9] * boxes[b + at[7]] + s[10] * boxes[b + at[8]] + s[11];
        double fourth = s[12] * boxes[b + at[9]] + s[13] * boxes[b + at[10]] + s[14] * boxes[b + at[11]] + s[15];
        return ((Double.doubleToRawLongBits(first) | Double.doubleToRawLongBits(second))
                | (Double.doubleToRawLongBits(third) | Double.doubleToRawLongBits(fourth))) >= 0;
    }

    /** A t before which no line meets the box whose six numbers start at b: as long as the way to it along the axis, no way is. */
    double distance(double[] boxes, int b) {
        return axisX * boxes[b + firstX] + axisY * boxes[b + firstY] + axisZ * boxes[b + firstZ] + along;
    }

    private void reserve(int most) {
        if (box.length < most) {
            box = Arrays.copyOf(box, most);
            near = Arrays.copyOf(near, most);
        }
    }

    /**
     * Puts a box that it reaches into upon those to be visited, from a place on, so that the nearest stay on top.
     *
     * @param top how many there are
     */
    void push(float[] data, int at, int from, int top) {
        // As long as the way to it along the axis, no way is.
        double distance = alongX * data[at + firstX] + alongY * data[at + firstY] + alongZ * data[at + firstZ] + along;
        int place = top;
        for (; place > from && near[place - 1] < distance; place--) {
            near[place] = near[place - 1];
            box[place] = box[place - 1];
        }
        near[place] = distance;
        box[place] = at;
    }
}
