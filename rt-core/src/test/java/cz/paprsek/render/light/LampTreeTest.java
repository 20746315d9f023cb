package cz.paprsek.render.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class LampTreeTest {
    private static final int COUNT = 37;

    private static LampTree tree() {
        List<Bounds> boxes = new ArrayList<>();
        double[] powers = new double[COUNT];
        for (int i = 0; i < COUNT; i++) {
            Vec3 place = new Vec3(i * 7 % 11, i * 5 % 13, i % 3);
            boxes.add(Bounds.of(place, place.plus(new Vec3(0.1, 0.2, 0))));
            powers[i] = 1 + i % 4;
        }
        return new LampTree(boxes, powers);
    }

    @Test
    void eachIsChosenAsOftenAsIsSaid() {
        LampTree tree = tree();
        LampTree.Choice choice = new LampTree.Choice();
        double[] often = new double[COUNT];
        int tries = 20_000;
        for (int i = 0; i < tries; i++) {
            tree.choose(2, 3, 1, (i + 0.5) / tries, choice);
            often[choice.lamp] += 1.0 / tries;
            assertThat(choice.left).isBetween(0.0, 1.0);
            assertThat(choice.chance).isCloseTo(tree.chance(choice.lamp, 2, 3, 1), within(1e-15));
        }
        double sum = 0;
        for (int i = 0; i < COUNT; i++) {
            assertThat(often[i]).isCloseTo(tree.chance(i, 2, 3, 1), within(2.0 / tries));
            sum += tree.chance(i, 2, 3, 1);
        }
        assertThat(sum).isCloseTo(1, within(1e-12));
    }

    @Test
    void whatIsNearAndStrongIsChosenMoreOften() {
        LampTree tree = tree();
        assertThat(tree.chance(0, 0.1, 0, 0)).isGreaterThan(10 * tree.chance(10, 0.1, 0, 0));
    }

    /** Where a ball is seen as a dot, its points are known as well as where it is near: else it stood in its own light. */
    @Test
    void pointsOfASmallBallFarAwayAreOnIt() {
        Lamp ball = new BallLamp(Rgb.WHITE, 1, new Vec3(3e4, 4e4, 0), 0.01);
        Hit origin = new Hit();
        Arrival arrival = new Arrival();
        for (int i = 0; i < 25; i++) {
            int row = i / 5;
            assertThat(ball.sample(origin, (i % 5 + 0.5) / 5, (row + 0.5) / 5, arrival)).isTrue();
            Vec3 point = new Vec3(arrival.x, arrival.y, arrival.z).times(arrival.distance);
            double away = point.minus(new Vec3(3e4, 4e4, 0)).length();
            assertThat(away / 0.01).isCloseTo(1, within(1e-3));
        }
    }
}
