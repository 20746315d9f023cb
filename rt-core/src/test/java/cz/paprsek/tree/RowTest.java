package cz.paprsek.tree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Balls asked at once, against the same formula for one: the same to the last bit. */
class RowTest {
    private static final int ROUNDS = 2000;

    @Test
    void aRowSaysOfEachBallWhatItsFormulaDoes() {
        Random random = new Random(7);
        for (int round = 0; round < ROUNDS; round++) {
            double[] balls = new double[4 * (1 + random.nextInt(Row.MOST))];
            Arrays.setAll(balls, i -> i % 4 == 3 ? (random.nextInt(5) == 0 ? Double.POSITIVE_INFINITY : random.nextDouble()) : random.nextGaussian());
            double[] ray = random.doubles(6, -1, 1).toArray();
            double length = Math.sqrt(ray[3] * ray[3] + ray[4] * ray[4] + ray[5] * ray[5]);
            for (int axis = 3; axis < 6; axis++) {
                ray[axis] /= length;
            }
            double[] halves = new double[Row.MOST];
            Row.of(balls).ifPresent(row -> {
                row.ask(ray[0], ray[1], ray[2], ray[3], ray[4], ray[5], halves);
                for (int i = 0; i < balls.length / 4; i++) {
                    assertThat(halves[i]).isEqualTo(half(ray, balls, 4 * i));
                }
            });
        }
    }

    /** Without vectors they are asked one by one, and so are more than a row holds. */
    @Test
    void thereIsARowOfAFewBallsWhereThereAreVectors() {
        assertThat(Row.of(new double[4 * Row.MOST]).isPresent()).isEqualTo(!"scalar".equals(Kernel.inUse()));
        assertThat(Row.of(new double[4 * Row.MOST + 4])).isEmpty();
    }

    private static double half(double[] ray, double[] balls, int at) {
        double lx = balls[at] - ray[0];
        double ly = balls[at + 1] - ray[1];
        double lz = balls[at + 2] - ray[2];
        double middle = lx * ray[3] + ly * ray[4] + lz * ray[5];
        double px = lx - middle * ray[3];
        double py = ly - middle * ray[4];
        double pz = lz - middle * ray[5];
        return balls[at + 3] - (px * px + py * py + pz * pz);
    }
}
