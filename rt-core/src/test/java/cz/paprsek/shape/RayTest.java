package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class RayTest {
    @Test
    void aRayMeetsABoxIfItPassesThroughWithinItsLength() {
        Random random = new Random(4);
        int met = 0;
        for (int i = 0; i < 200_000; i++) {
            double[] o = random.doubles(3, -2, 2).toArray();
            double[] d = random.doubles(3, -1.5, 1.5).toArray();
            Arrays.setAll(d, k -> d[k] - o[k]);
            if (i % 5 == 0) {
                d[i % 3] = 0;
            }
            double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
            double[] low = random.doubles(3, -1, 1).toArray();
            double[] high = random.doubles(3, 0, 3).toArray();
            double min = i % 2 == 0 ? 0 : random.nextDouble();
            double max = i % 3 == 0 ? Double.POSITIVE_INFINITY : min + 2 * random.nextDouble();
            double near = min;
            double far = max;
            for (int k = 0; k < 3; k++) {
                high[k] += low[k];
                d[k] /= length;
                double a = (low[k] - o[k]) / d[k];
                double b = (high[k] - o[k]) / d[k];
                near = Math.max(near, Math.min(a, b));
                far = Math.min(far, Math.max(a, b));
            }
            Ray ray = new Ray(new Spans());
            ray.start(o[0], o[1], o[2], d[0], d[1], d[2]);
            ray.min = min;
            ray.max = max;
            boolean meets = ray.meets(new Bounds(low[0], low[1], low[2], high[0], high[1], high[2]));
            if (Math.abs(near - far) > 1e-12) {
                assertThat(meets).as("ray %s, from %s along %s", i, o, d).isEqualTo(near < far);
            }
            met += meets ? 1 : 0;
        }
        assertThat(met).isBetween(10_000, 190_000);
    }

    @Test
    void aRayStartsWithNothingHitAndKnowsWhatTouchesItsStart() {
        Ray ray = new Ray(new Spans());
        ray.start(3, -4, 5, 0, 0, 1);
        assertThat(ray.scale).isEqualTo(12);
        assertThat(ray.min).isZero();
        assertThat(ray.max).isInfinite();
        ray.accept(2, 7, 1);
        assertThat(ray.max).isEqualTo(2);
        ray.start(3, -4, 5, 0, 0, 1, 100, 8, 7, true);
        assertThat(ray.part).isEqualTo(-1);
        assertThat(ray.contact).isEqualTo(100 * Ray.TOUCH);
        assertThat(ray.min).isEqualTo(-ray.contact);
        assertThat(ray.max).isEqualTo(8);
        ray.start(3, -4, 5, 0, 0, 1);
        assertThat(ray.left).as("from the eye again").isEqualTo(-1);
        assertThat(ray.min).isZero();
    }

    @Test
    void aRayMeetsABoxThatItTouchesAtACorner() {
        Ray ray = new Ray(new Spans());
        ray.start(0, 0, 0, 1, 0, 0);
        assertThat(ray.meets(Bounds.around(new Vec3(5, 1, 0), Vec3.ONE))).as("along an edge").isTrue();
        ray.start(0, 0, 0, Math.sqrt(0.5), Math.sqrt(0.5), 0);
        assertThat(ray.meets(Bounds.around(new Vec3(5, 3, 0), Vec3.ONE))).as("through a corner").isTrue();
        ray.max = Math.sqrt(32) - 1e-9;
        assertThat(ray.meets(Bounds.around(new Vec3(5, 3, 0), Vec3.ONE))).as("ending before the corner").isFalse();
    }
}
