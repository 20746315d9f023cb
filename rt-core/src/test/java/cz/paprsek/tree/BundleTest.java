package cz.paprsek.tree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a bundle says of the lengths of its lines, against a box of directions in closed form, and of what they meet, against each line. */
class BundleTest {
    private static final double[] DIRECTIONS = {0, -0.0, 1e-310, -1e-310, 1e-301, -1e-301, 1e-20, -1e-20, 1, -1};
    private static final double[] PLACES = {0, -0.0, 1, -1, 2, -3, 0.3, -0.7, 1e45, -1e45};
    /** More than doubles have, whose exact digits are many where they are small. */
    private static final MathContext DIGITS = MathContext.DECIMAL128;

    /** Boxes often touch the one where lines begin, or have its sides in common. */
    @Test
    void noBoxIsLeftOutThatALineMeets() {
        Random random = new Random(4);
        Bundle bundle = new Bundle();
        int met = 0;
        int leftOut = 0;
        for (int round = 0; round < 3000; round++) {
            double[] from = three(PLACES, random);
            double[] to = round % 2 == 0 ? from.clone() : three(PLACES, random);
            order(from, to);
            double[] min = three(PLACES, random);
            double[] max = three(PLACES, random);
            for (int touching = random.nextInt(4); touching > 0; touching--) {
                int axis = random.nextInt(3);
                if (random.nextBoolean()) {
                    min[axis] = to[axis];
                } else {
                    max[axis] = from[axis];
                }
            }
            order(min, max);
            double[][] directions = {three(DIRECTIONS, random), three(DIRECTIONS, random)};
            double end = random.nextBoolean() ? Double.POSITIVE_INFINITY : random.nextInt(4);
            bundle.start(from[0], from[1], from[2], to[0], to[1], to[2]);
            bundle.end(end);
            for (int i = round / 2 % 2; i < 2; i++) {
                bundle.add(directions[i][0], directions[i][1], directions[i][2]);
            }
            assertThat(bundle.shortest()).isNotNegative();
            double enter = bundle.enter(min[0], min[1], min[2], max[0], max[1], max[2]);
            leftOut += enter == Double.POSITIVE_INFINITY ? 1 : 0;
            for (int i = 0; i < 3; i++) {
                double[] start = random.nextBoolean() ? from : to;
                double[] d = directions[round / 2 % 2 == 1 ? 1 : random.nextInt(2)];
                BigDecimal meets = meets(start, d, min, max, end);
                if (meets != null) {
                    met++;
                    assertThat(enter).as("round %d", round).isFinite();
                    assertThat(new BigDecimal(enter)).as("round %d", round).isLessThanOrEqualTo(meets);
                }
            }
        }
        assertThat(met).isGreaterThan(1000);
        assertThat(leftOut).isGreaterThan(1000);
    }

    /** What lies where lines go, however slowly, they may meet; what lies beside them or behind, they do not. */
    @ParameterizedTest
    @ValueSource(doubles = {0, -0.0, -1e-310, -1e-301, -1e-20, -1, 1e-310, 1e-301, 1e-20, 1})
    void aWayThatIsNoneLeadsNowhere(double d) {
        Bundle bundle = new Bundle();
        bundle.start(0, 0, 0);
        bundle.add(d, 0, 0);
        bundle.add(d, 1e-310, 1e-310);
        assertThat(bundle.shortest()).isNotNegative();
        assertThat(Double.isFinite(bundle.enter(3, -1, -1, 4, 1, 1))).isEqualTo(d > 0);
        assertThat(Double.isFinite(bundle.enter(-4, -1, -1, -3, 1, 1))).isEqualTo(d < 0);
        assertThat(bundle.enter(0, -1, -1, 4, 1, 1)).isZero();
    }

    /** The first t, from 0 to the end, at which a line is in a box; null if there is none. */
    private static @Nullable BigDecimal meets(double[] start, double[] d, double[] min, double[] max, double end) {
        BigDecimal near = BigDecimal.ZERO;
        BigDecimal far = end == Double.POSITIVE_INFINITY ? null : new BigDecimal(end);
        for (int axis = 0; axis < 3; axis++) {
            if (d[axis] == 0) {
                if (!(min[axis] <= start[axis] && start[axis] <= max[axis])) {
                    return null;
                }
                continue;
            }
            BigDecimal over = new BigDecimal(d[axis], DIGITS);
            BigDecimal first = new BigDecimal(d[axis] > 0 ? min[axis] : max[axis]).subtract(new BigDecimal(start[axis])).divide(over, DIGITS);
            BigDecimal last = new BigDecimal(d[axis] > 0 ? max[axis] : min[axis]).subtract(new BigDecimal(start[axis])).divide(over, DIGITS);
            near = near.max(first);
            far = far == null ? last : far.min(last);
        }
        return far == null || near.compareTo(far) <= 0 ? near : null;
    }

    private static double[] three(double[] of, Random random) {
        return random.ints(3, 0, of.length).mapToDouble(i -> of[i]).toArray();
    }

    private static void order(double[] low, double[] high) {
        for (int axis = 0; axis < 3; axis++) {
            double least = Math.min(low[axis], high[axis]);
            high[axis] = Math.max(low[axis], high[axis]);
            low[axis] = least;
        }
    }

    @Test
    void noDirectionIsShorterOrLongerThanTheBundleSays() {
        Random random = new Random(2);
        Bundle bundle = new Bundle();
        for (int round = 0; round < 2000; round++) {
            double[] middle = random.doubles(3, -5, 5).toArray();
            double reach = 3 * random.nextDouble();
            bundle.start(0, 0, 0);
            for (int corner = 0; corner < 8; corner++) {
                bundle.add(middle[0] + (corner % 2 == 0 ? reach : -reach), middle[1] + (corner / 2 % 2 == 0 ? reach : -reach), middle[2] + (corner / 4 == 0 ? reach : -reach));
            }
            double most = 0;
            double least = 0;
            for (double m : middle) {
                most += Math.pow(Math.abs(m) + reach, 2);
                least += Math.pow(Math.max(0, Math.abs(m) - reach), 2);
            }
            assertThat(bundle.longest()).isBetween(Math.sqrt(most) * (1 - 1e-12), Math.sqrt(3 * most) * (1 + 1e-12));
            assertThat(bundle.shortest()).isCloseTo(Math.sqrt(least), within(1e-11));
        }
    }
}
