package cz.paprsek.tree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** What a bundle says of the lengths of its lines, against a box of directions in closed form. */
class BundleTest {
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
