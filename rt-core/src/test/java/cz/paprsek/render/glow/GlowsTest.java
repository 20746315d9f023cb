package cz.paprsek.render.glow;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GlowsTest {
    private static final int RAYS = 20_000;
    private final Random random = new Random(7);

    /** Balls, rectangles and discs, every fifth where the one before stands. */
    private List<Light> lights(int count) {
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            lights.add(i % 5 == 4 ? lights.get(i - 1) : switch (random.nextInt(3)) {
                case 0 -> SphereLight.of(point(4), 0.1 + random.nextDouble());
                case 1 -> AreaLight.rectangle(point(4), 1, 0.5).withRotation(point(180));
                default -> AreaLight.disc(point(4), 0.7).withRotation(point(180));
            });
        }
        return lights;
    }

    private Vec3 point(double size) {
        return new Vec3(size * (2 * random.nextDouble() - 1), size * (2 * random.nextDouble() - 1), size * (2 * random.nextDouble() - 1));
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 17, 200})
    void aTreeOfLightsFindsWhatIsFoundOneByOne(int count) {
        Glows all = Glows.of(lights(count), 5);
        Glows one = all.forOneWorker();
        assertThat(one instanceof ManyGlows).as("few are looked at one by one").isEqualTo(count > Glows.FEW);
        int hits = 0;
        int blocked = 0;
        for (int i = 0; i < RAYS; i++) {
            Vec3 origin = point(6);
            Vec3 direction = point(1).normalized();
            Ray expected = start(origin, direction, i);
            Ray found = start(origin, direction, i);
            all.nearest(expected);
            one.nearest(found);
            assertThat(new double[] {found.max, found.part, found.face}).as("ray %d", i).isEqualTo(new double[] {expected.max, expected.part, expected.face});
            hits += expected.part >= 5 ? 1 : 0;
            int lamp = i % count;
            boolean isBlocked = all.occludes(start(origin, direction, i), lamp);
            assertThat(one.occludes(start(origin, direction, i), lamp)).as("ray %d", i).isEqualTo(isBlocked);
            blocked += isBlocked ? 1 : 0;
        }
        assertThat(hits).isGreaterThan(50);
        assertThat(blocked).isGreaterThan(50);
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 17, 200})
    void whatIsInTheWayFirstIsNamed(int count) {
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            // One behind the other along x in an order that is neither that of the list nor the opposite.
            lights.add(SphereLight.of(new Vec3(1 + (7 * i + 3) % count, 0, 0), 0.25));
        }
        Glows all = Glows.of(lights, 5);
        for (int lamp = 0; lamp < count; lamp++) {
            int expected = 0;
            for (int i = 0; i < count; i++) {
                if (i != lamp && (7 * i + 3) % count == ((7 * lamp + 3) % count == 0 ? 1 : 0)) {
                    expected = i;
                }
            }
            Ray ray = new Ray(new Spans());
            ray.start(0, 0, 0, 1, 0, 0);
            assertThat(all.forOneWorker().nearestOccluder(ray, lamp)).as("lamp %d", lamp).isEqualTo(expected);
        }
        Ray aside = new Ray(new Spans());
        aside.start(0, 5, 0, 1, 0, 0);
        assertThat(all.forOneWorker().nearestOccluder(aside, 0)).isEqualTo(Glows.NONE);
    }

    /** From the eye, from a surface, and with something hit before. */
    private static Ray start(Vec3 origin, Vec3 direction, int way) {
        Ray ray = new Ray(new Spans());
        if (way % 3 == 0) {
            ray.start(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z(), 10, 8, 6, false);
        } else {
            ray.start(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
        }
        if (way % 3 == 1) {
            ray.accept(4, 2, 0);
        }
        return ray;
    }
}
