package cz.paprsek.shape.placed;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Hit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A body on the stretch from 2 to 4 of every line: what lies strictly between the ends of a ray counts. */
class ConvexTest {
    private static final int PART = 5;
    private static final int FRONT = 10;
    private static final int BACK = 11;

    private final Ray ray = new Ray(new Spans());
    private final Convex body = new Slab();

    private void between(double from, double to) {
        Ray whole = new Ray(new Spans());
        whole.start(0, 0, 0, 0, 0, 1);
        ray.within(whole, from, to);
    }

    @ParameterizedTest
    @CsvSource({"0, 10, 2", "0, 2.5, 2", "1.9, 4, 2", "2, 10, 4", "2, 4.5, 4", "3, 10, 4", "0, 2, -1", "2, 4, -1", "3, 4, -1", "3, 3.5, -1", "4, 10, -1", "5, 10, -1"})
    void theFirstEndBetweenIsHit(double from, double to, double hit) {
        between(from, to);
        body.nearest(ray);
        assertThat(ray.part).isEqualTo(hit < 0 ? -1 : PART);
        if (hit >= 0) {
            assertThat(ray.max).isEqualTo(hit);
            assertThat(ray.face).isEqualTo(hit == 2 ? FRONT : BACK);
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 10, true", "0, 2.5, true", "1, 4, true", "2, 10, true", "2, 4.5, true", "3, 5, true", "0, 2, false", "2, 4, false", "3, 4, false", "3, 3.5, false",
        "4, 10, false", "5, 10, false"})
    void itIsInTheWayIfOneOfItsEndsIsBetween(double contact, double to, boolean isInTheWay) {
        between(0, to);
        ray.contact = contact;
        assertThat(body.occludes(ray)).isEqualTo(isInTheWay);
    }

    @Test
    void whoStartsOnItMeetsOnlyItsOtherSideAndOnlyFromWithin() {
        ray.start(0, 0, 0, 0, 0, 1, 1, 10, PART, true);
        body.nearest(ray);
        assertThat(ray.max).isEqualTo(4);
        assertThat(ray.face).isEqualTo(BACK);
        ray.start(0, 0, 0, 0, 0, 1, 1, 10, PART, false);
        body.nearest(ray);
        assertThat(ray.part).isEqualTo(-1);
        assertThat(body.occludes(ray)).isFalse();
    }

    @Test
    void ofTwoWallsInOnePlaceTheFirstStaysAndAStretchWithoutLengthIsNone() {
        body.clip(ray);
        assertThat(Convex.narrow(ray, 2, 20, 4, 21)).isTrue();
        assertThat(new int[] {ray.enterFace, ray.leaveFace}).containsExactly(FRONT, BACK);
        assertThat(Convex.narrow(ray, 2.5, 20, 3.5, 21)).isTrue();
        assertThat(new double[] {ray.enter, ray.leave}).containsExactly(2.5, 3.5);
        assertThat(new int[] {ray.enterFace, ray.leaveFace}).containsExactly(20, 21);
        assertThat(Convex.narrow(ray, 3.5, 30, 9, 31)).as("from 3.5 to 3.5").isFalse();
    }

    private static final class Slab extends Convex {
        Slab() {
            super(PART);
        }

        @Override
        protected boolean clip(Ray ray) {
            ray.enter = Double.NEGATIVE_INFINITY;
            ray.leave = Double.POSITIVE_INFINITY;
            return narrow(ray, 2, FRONT, 4, BACK);
        }

        @Override
        public Bounds bounds() {
            return Bounds.ALL;
        }

        @Override
        public void describe(int face, Hit hit) {}

        @Override
        public void map(int face, Hit hit) {}
    }
}
