package cz.paprsek.tree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** What a frustum says no line within it meets, against lines within it. */
class FrustumTest {
    private static final int ROUNDS = 4000;

    /** Balls are put where they just touch a line, or where they nearly do. */
    @Test
    void noBallIsLeftOutThatALineMeets() {
        Random random = new Random(1);
        int leftOut = 0;
        for (int round = 0; round < ROUNDS; round++) {
            double[] corners = corners(random, Math.pow(10, -4 * random.nextDouble()));
            double[] origin = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
            double radius = Math.pow(10, -3 * random.nextDouble());
            double[] d = between(corners, random);
            double[] aside = cross(d, three(random));
            double t = 10 * random.nextDouble();
            double off = radius * (random.nextBoolean() ? 1 - 1e-9 : 1 + 3 * random.nextDouble());
            double k = off / length(aside);
            Bundle bundle = new Bundle();
            bundle.start(origin[0], origin[1], origin[2]);
            addAll(bundle, corners);
            boolean meets = bundle.frustum().meetsBall(origin[0] + t * d[0] + k * aside[0], origin[1] + t * d[1] + k * aside[1],
                    origin[2] + t * d[2] + k * aside[2], radius * radius);
            assertThat(meets || off > radius).as("round %d", round).isTrue();
            leftOut += meets ? 0 : 1;
        }
        assertThat(leftOut).as("balls beside it").isGreaterThan(ROUNDS / 20);
    }

    /** If a point of a box lies on a line, the line meets it, no sooner than where the box is put among the others. */
    @Test
    void noBoxIsPutLaterThanALineMeetsIt() {
        Random random = new Random(2);
        int leftOut = 0;
        for (int round = 0; round < ROUNDS; round++) {
            double[] corners = corners(random, Math.pow(10, -4 * random.nextDouble()));
            double[] d = between(corners, random);
            double t = Math.pow(10, 4 * random.nextDouble());
            double[] origin = new double[3];
            double[] boxes = new double[12];
            for (int axis = 0; axis < 3; axis++) {
                double at = random.nextDouble();
                origin[axis] = at - t * d[axis];
                boxes[axis] = at - random.nextDouble() * random.nextInt(2);
                boxes[3 + axis] = at + random.nextDouble() * random.nextInt(2);
                boxes[6 + axis] = 20;
                boxes[9 + axis] = 21;
            }
            Bundle bundle = new Bundle();
            bundle.start(origin[0], origin[1], origin[2]);
            addAll(bundle, corners);
            WideNodes nodes = new WideNodes(new BinaryNodes(boxes, new int[] {Tree.leaf(0, 1, 9), Tree.leaf(1, 1, 9)}, 0, 2, i -> 9, () -> false), 8);
            assertThat(bundle.frustum().aim(nodes, 3 * 8)).isTrue();
            int slot = WideNodes.FIRST + (Float.floatToRawIntBits(nodes.data[WideNodes.FIRST + 48]) == Tree.leaf(0, 1, 9) ? 0 : 1);
            for (int side = 0; side < Frustum.SIDES; side++) {
                assertThat(inside(bundle.frustum(), side, nodes.data, slot)).as("round %d", round).isNotNegative();
            }
            bundle.frustum().push(nodes.data, slot, 0, 0);
            assertThat(bundle.frustum().near[0]).as("round %d", round).isLessThanOrEqualTo(t);
            bundle.frustum().aim(21, 2);
            assertThat(bundle.frustum().meets(boxes, 0)).as("round %d", round).isTrue();
            assertThat(bundle.frustum().distance(boxes, 0)).as("round %d", round).isLessThanOrEqualTo(t);
            leftOut += bundle.frustum().meets(boxes, 6) ? 0 : 1;
        }
        assertThat(leftOut).as("boxes elsewhere").isGreaterThan(ROUNDS / 2);
    }

    /** Of four directions that nearly are one no planes are made, since they would be anywhere. */
    @Test
    void whatIsTooNarrowIsAskedAboutOtherwise() {
        Bundle bundle = new Bundle();
        bundle.start(0, 0, 0);
        addAll(bundle, new double[] {0, 0, 1, 1e-7, 0, 1, 1e-7, 1e-7, 1, 0, 1e-7, 1});
        assertThat(bundle.hasFrustum()).isFalse();
        bundle.start(0, 0, 0);
        addAll(bundle, new double[] {0, 0, 1, 1e-3, 0, 1, 1e-3, 1e-3, 1, 0, 1e-3, 1});
        assertThat(bundle.hasFrustum()).isTrue();
        bundle.start(0, 0, 0);
        assertThat(bundle.hasFrustum()).isFalse();
    }

    /** How far inside a side a box reaches, in floats as vectors reckon. */
    private static float inside(Frustum frustum, int side, float[] data, int at) {
        return data[at + frustum.atX[side]] * frustum.x[side] + data[at + frustum.atY[side]] * frustum.y[side] + data[at + frustum.atZ[side]] * frustum.z[side]
                + frustum.w[side];
    }

    private static void addAll(Bundle bundle, double[] corners) {
        for (int i = 0; i < corners.length; i += 3) {
            bundle.addCorner(corners[i], corners[i + 1], corners[i + 2]);
        }
    }

    /** Those of a rectangle somewhere in front. */
    private static double[] corners(Random random, double size) {
        double[] middle = three(random);
        double[] right = cross(middle, three(random));
        double[] up = cross(middle, right);
        double[] corners = new double[12];
        for (int corner = 0; corner < 4; corner++) {
            double p = size * length(middle) / length(right) * (corner == 0 || corner == 3 ? -1 : 1);
            double q = size * length(middle) / length(up) * (corner < 2 ? -1 : 1);
            for (int axis = 0; axis < 3; axis++) {
                corners[3 * corner + axis] = middle[axis] + p * right[axis] + q * up[axis];
            }
        }
        return corners;
    }

    private static double[] between(double[] corners, Random random) {
        double u = random.nextInt(4) == 0 ? random.nextInt(2) : random.nextDouble();
        double v = random.nextInt(4) == 0 ? random.nextInt(2) : random.nextDouble();
        double[] d = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            d[axis] = (1 - v) * ((1 - u) * corners[axis] + u * corners[3 + axis]) + v * ((1 - u) * corners[9 + axis] + u * corners[6 + axis]);
        }
        double length = length(d);
        return new double[] {d[0] / length, d[1] / length, d[2] / length};
    }

    private static double[] three(Random random) {
        return new double[] {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double length(double[] a) {
        return Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    }
}
