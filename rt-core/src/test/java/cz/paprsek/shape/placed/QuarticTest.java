package cz.paprsek.shape.placed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

/** A cubic with roots that are known has them as its turning points, and no others. */
class QuarticTest {
    private final double[] breaks = new double[3];

    /** Roots that add up to 0: 4(s − a)(s − b)(s − c) = 4s³ + 4(ab + bc + ca)s − 4abc. */
    @Test
    void theThreeTurningPointsAreFoundAsFarAsTheReach() {
        Random random = new Random(3);
        int three = 0;
        for (int round = 0; round < 5000; round++) {
            double a = random.nextInt(-50, 51);
            double b = random.nextInt(-50, 51);
            double c = -a - b;
            if (a == b || b == c || c == a) {
                continue;
            }
            double reach = random.nextInt(1, 100) + 0.5;
            int count = Quartic.turningPoints(2 * (a * b + b * c + c * a), -4 * a * b * c, reach, breaks);
            double[] within = DoubleStream.of(a, b, c).filter(s -> Math.abs(s) < reach).sorted().toArray();
            assertThat(count).as("%s %s %s within %s", a, b, c, reach).isEqualTo(within.length);
            for (int i = 0; i < count; i++) {
                assertThat(breaks[i]).isCloseTo(within[i], within(1e-12 * Math.max(1, Math.abs(within[i]))));
            }
            three += count == 3 ? 1 : 0;
        }
        assertThat(three).isGreaterThan(1000);
    }

    /** 4(s − a)(s² + as + q) with q above a²/4. */
    @Test
    void aSlopeThatOnlyRisesHasOne() {
        Random random = new Random(4);
        for (int round = 0; round < 2000; round++) {
            double a = random.nextInt(-20, 21);
            double q = a * a / 4 + random.nextInt(1, 100);
            int count = Quartic.turningPoints(2 * (q - a * a), -4 * a * q, 30, breaks);
            assertThat(Arrays.copyOf(breaks, count)).hasSize(1);
            assertThat(breaks[0]).isCloseTo(a, within(1e-12 * Math.max(1, Math.abs(a))));
            assertThat(Quartic.turningPoints(2 * (q - a * a), -4 * a * q, Math.abs(a) / 2, breaks)).isZero();
        }
    }
}
