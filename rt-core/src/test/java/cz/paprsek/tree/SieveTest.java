package cz.paprsek.tree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Triangles with corners on a grid, and lines through it: then products and sums are exact, and many lines meet sides and corners. */
class SieveTest {
    private static final int MANY = 4000;
    private static final int GRID = 5;

    private final Random random = new Random(11);

    @Test
    void whatIsPassedByHasTheLineOnDifferentSidesOfTwoOfItsSides() {
        Sieve sieve = Sieve.suitedTo(MANY, 1);
        boolean isCoarse = "scalar".equals(Kernel.inUse());
        int passed = 0;
        for (int round = 0; round < 50; round++) {
            float[] triangles = new float[Sieve.EACH * MANY + Sieve.BEHIND];
            for (int i = 0; i < triangles.length; i++) {
                triangles[i] = i % Sieve.EACH == Sieve.EACH - 1 ? Float.intBitsToFloat(random.nextInt()) : random.nextInt(GRID);
            }
            int[] axes = {3 * (round % 3), 3 * ((round + 1) % 3), 3 * ((round + 2) % 3)};
            double[] line = {random.nextInt(GRID), random.nextInt(GRID), random.nextInt(GRID), (random.nextInt(5) - 2) / 2.0, (random.nextInt(5) - 2) / 2.0};
            int expected = 0;
            for (int found = next(sieve, triangles, 0, axes, line); expected < MANY; expected++) {
                assertThat(found).isGreaterThanOrEqualTo(expected);
                if (found == expected) {
                    assertThat(isCoarse || !hasBothSigns(triangles, expected, axes, line)).isTrue();
                    found = next(sieve, triangles, expected + 1, axes, line);
                } else {
                    assertThat(hasBothSigns(triangles, expected, axes, line)).isTrue();
                    passed++;
                }
            }
        }
        assertThat(passed > 0).isNotEqualTo(isCoarse);
    }

    @Test
    void fewTrianglesAreAllAsked() {
        assertThat(Sieve.suitedTo(12, 1).next(new float[12 * Sieve.EACH + Sieve.BEHIND], 3, 12, 0, 3, 6, 9, 9, 9, 0, 0)).isEqualTo(3);
    }

    private static int next(Sieve sieve, float[] triangles, int from, int[] axes, double[] line) {
        return from == MANY ? MANY : sieve.next(triangles, from, MANY, axes[0], axes[1], axes[2], line[0], line[1], line[2], line[3], line[4]);
    }

    private static boolean hasBothSigns(float[] triangles, int number, int[] axes, double[] line) {
        double[] x = new double[3];
        double[] y = new double[3];
        for (int corner = 0; corner < 3; corner++) {
            int at = Sieve.EACH * number + corner;
            double z = triangles[at + axes[2]] - line[2];
            x[corner] = triangles[at + axes[0]] - line[0] - line[3] * z;
            y[corner] = triangles[at + axes[1]] - line[1] - line[4] * z;
        }
        int signs = 0;
        for (int corner = 0; corner < 3; corner++) {
            int then = (corner + 1) % 3;
            double side = x[corner] * y[then] - y[corner] * x[then];
            signs |= side > 0 ? 1 : side < 0 ? 2 : 0;
        }
        return signs == 3;
    }
}
