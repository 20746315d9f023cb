package cz.paprsek.shape.placed;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.shape.Csg.Operation;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class SpansTest {
    private static final int LEFT = 1;
    private static final int RIGHT = 2;

    private final Spans spans = new Spans();

    @ParameterizedTest
    @EnumSource
    void runsOfAnyLengthCombineAsSets(Operation operation) {
        Random random = new Random(6);
        for (int round = 0; round < 2000; round++) {
            int below = random.nextInt(5);
            double[] left = run(random);
            double[] right = run(random);
            // What was left above by others must not matter.
            spans.release(0);
            push(random.doubles(below + 100, -1, 11).toArray(), LEFT);
            spans.release(below);
            combine(operation, left, right, 1);
            for (int i = 0; i < 50; i++) {
                double t = random.nextDouble() * 10;
                assertThat(isIn(t, result(below))).as("in the combination at %s", t)
                        .isEqualTo(operation.inside(isIn(t, left), isIn(t, right)));
            }
            assertThat(result(below)).isSorted();
        }
    }

    @ParameterizedTest
    @CsvSource({
        // A tie is 1e-11 of the size of the numbers: here, of 1000 + 10.
        "1000, 1.00e-8, 2", "1000, 1.02e-8, 4", "1000, -1.00e-8, 2",
        "0, 0.9e-10, 2", "0, 1.1e-10, 4"})
    void wallsThatTouchAreNoWalls(double scale, double gap, int boundaries) {
        combine(Operation.UNION, new double[] {5, 10}, new double[] {10 + gap, 20}, scale);
        assertThat(spans.size()).isEqualTo(boundaries);
        spans.release(0);
        combine(Operation.UNION, new double[] {10 + gap, 20}, new double[] {5, 10}, scale);
        assertThat(spans.size()).isEqualTo(boundaries);
    }

    @Test
    void aSliceThinnerThanATieCutsNothing() {
        combine(Operation.DIFFERENCE, new double[] {0, 6}, new double[] {3, 3 + 1e-12}, 1);
        assertThat(result(0)).containsExactly(0, 6);
        spans.release(0);
        combine(Operation.INTERSECTION, new double[] {2, 2 + 1e-12, 4, 5}, new double[] {0, 4.5}, 1);
        assertThat(result(0)).containsExactly(4, 4.5);
    }

    @Test
    void whatIsCutOutIsTurnedInsideOut() {
        combine(Operation.DIFFERENCE, new double[] {0, 6}, new double[] {-1, 2, 4, 5}, 1);
        assertThat(result(0)).containsExactly(2, 4, 5, 6);
        assertThat(IntStream.range(0, 4).map(spans::part)).containsExactly(RIGHT, RIGHT, RIGHT, LEFT);
        assertThat(IntStream.range(0, 4).map(spans::face)).containsExactly(~RIGHT, ~RIGHT, ~RIGHT, LEFT);
    }

    @Test
    void ofTwoWallsInOnePlaceTheFirstIsSeen() {
        combine(Operation.UNION, new double[] {1, 3}, new double[] {1, 4}, 1);
        assertThat(spans.part(0)).isEqualTo(LEFT);
        spans.release(0);
        combine(Operation.INTERSECTION, new double[] {1, 3}, new double[] {1 - 1e-12, 4}, 1);
        assertThat(spans.part(0)).isEqualTo(LEFT);
        assertThat(result(0)).containsExactly(1, 3);
    }

    @Test
    void bodiesWithoutEndHaveOneWall() {
        combine(Operation.DIFFERENCE, new double[] {Double.NEGATIVE_INFINITY, 4}, new double[] {1, Double.POSITIVE_INFINITY}, 1);
        assertThat(result(0)).containsExactly(Double.NEGATIVE_INFINITY, 1);
    }

    /** In place or pushed and merged: the same boundaries, parts and faces; the runs may begin or end anywhere. */
    @ParameterizedTest
    @EnumSource
    void aConvexBodyIsCombinedInPlaceAsIfItWerePushed(Operation operation) {
        Random random = new Random(7);
        Spans pushed = new Spans();
        int inPlace = 0;
        for (int round = 0; round < 2000; round++) {
            double[] left = Arrays.stream(run(random)).map(t -> Math.rint(t * 10)).distinct().toArray();
            left = Arrays.copyOf(left, left.length & ~1);
            double enter = random.nextInt(100) + 0.5;
            double leave = enter + 1 + random.nextInt(40);
            spans.release(0);
            push(left, LEFT);
            pushed.release(0);
            for (double t : left) {
                pushed.add(t, LEFT, LEFT);
            }
            pushed.add(enter, RIGHT, 3);
            pushed.add(leave, RIGHT, 4);
            pushed.combine(operation, 0, left.length, 1);
            assertThat(spans.combine(operation, 0, enter, 3, leave, 4, RIGHT, 1)).isTrue();
            assertThat(boundaries(spans)).isEqualTo(boundaries(pushed));
            inPlace += spans.size() > 2 ? 1 : 0;
        }
        assertThat(inPlace).isGreaterThan(100);
    }

    /** Twice a tie's reach, of the scale and of where they are: 2e-11 of 1000 + 10 is 2.02e-8. */
    @ParameterizedTest
    @CsvSource({"1000, 10, 2.0e-8, false", "1000, 10, 2.1e-8, true", "1000, -10, 2.0e-8, false", "1000, -10, 2.1e-8, true",
        "0, 10, 1.9e-10, false", "0, 10, 2.1e-10, true"})
    void inPlaceOnlyWhereNothingTouches(double scale, double at, double gap, boolean isApart) {
        for (double sign : new double[] {-1, 1}) {
            double[][] runs = {{at, 20}, {at - 5, at, at + sign * gap, 20}, {-20, at}};
            double[][] stretches = {{at + sign * gap, 15}, {at + 2, at + 3}, {-15, at + sign * gap}};
            for (int i = 0; i < runs.length; i++) {
                double[] run = runs[i].clone();
                Arrays.sort(run);
                spans.release(0);
                push(run, LEFT);
                assertThat(spans.combine(Operation.UNION, 0, stretches[i][0], 3, stretches[i][1], 4, RIGHT, scale))
                        .as("%s with %s", Arrays.toString(run), Arrays.toString(stretches[i])).isEqualTo(isApart);
                if (!isApart) {
                    assertThat(result(0)).as("nothing has changed").containsExactly(run);
                }
            }
        }
        spans.release(0);
        double thin = 2 * gap;
        assertThat(spans.combine(Operation.UNION, 0, at, 3, at + thin, 4, RIGHT, scale)).as("a slice").isEqualTo(
                thin > 2e-11 * (scale + Math.abs(at) + Math.abs(at + thin)));
    }

    @Test
    void stretchesReachBetweenMinAndMaxOnly() {
        Ray ray = new Ray(new Spans());
        ray.start(0, 0, 0, 0, 0, 1);
        assertThat(spans.reaches(0, ray)).as("none").isFalse();
        push(new double[] {-3, -1}, LEFT);
        assertThat(spans.reaches(0, ray)).as("behind").isFalse();
        push(new double[] {2, 4}, LEFT);
        assertThat(spans.reaches(0, ray)).isTrue();
        assertThat(spans.reaches(2, ray)).isTrue();
        ray.accept(3, RIGHT, 0);
        assertThat(spans.reaches(2, ray)).isTrue();
        ray.accept(1, RIGHT, 0);
        assertThat(spans.reaches(2, ray)).as("beyond what is hit").isFalse();
    }

    @Test
    void whoStartsOnABodyLeavesWhatIsNearestAndLeadsItsWay() {
        push(new double[] {-9}, LEFT);
        push(new double[] {-3, 1e-13, 2, 5}, RIGHT);
        spans.leaveFrom(1, false);
        assertThat(result(0)).as("out of it").containsExactly(-9, 2, 5);
        spans.release(1);
        push(new double[] {-3, -1, 1e-13, 4}, RIGHT);
        spans.leaveFrom(1, true);
        assertThat(result(0)).as("into it").containsExactly(-9, Double.NEGATIVE_INFINITY, 4);
        spans.release(1);
        push(new double[] {-1e-13, -1e-14, 3, 4}, RIGHT);
        spans.leaveFrom(1, true);
        assertThat(result(0)).as("into what is thinner than rounding").containsExactly(-9, Double.NEGATIVE_INFINITY, 0, 3, 4);
        spans.release(1);
        spans.leaveFrom(1, true);
        assertThat(result(0)).as("nothing there").containsExactly(-9);
    }

    private static List<List<Number>> boundaries(Spans of) {
        return IntStream.range(0, of.size()).mapToObj(i -> List.<Number>of(of.t(i), of.part(i), of.face(i))).toList();
    }

    private void combine(Operation operation, double[] left, double[] right, double scale) {
        int mark = spans.size();
        push(left, LEFT);
        int middle = spans.size();
        push(right, RIGHT);
        spans.combine(operation, mark, middle, scale);
    }

    private void push(double[] where, int part) {
        for (double t : where) {
            spans.add(t, part, part);
        }
    }

    private double[] result(int from) {
        return IntStream.range(from, spans.size()).mapToDouble(spans::t).toArray();
    }

    private static double[] run(Random random) {
        double low = random.nextDouble() * 10;
        double high = low + random.nextDouble() * (10 - low);
        double[] run = random.doubles(2L * random.nextInt(50), low, Math.nextUp(high)).toArray();
        Arrays.sort(run);
        return run;
    }

    private static boolean isIn(double t, double[] run) {
        return Arrays.stream(run).filter(boundary -> boundary <= t).count() % 2 != 0;
    }
}
