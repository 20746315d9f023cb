package cz.paprsek.shape.placed;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.shape.Csg.Operation;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class StretchTest {
    private static final int LEFT = 1;
    private static final int RIGHT = 2;
    private static final int ROUNDS = 20_000;

    /** A boundary, down to the last bit. */
    private record Boundary(double t, int part, int face) {}

    @ParameterizedTest
    @EnumSource
    void aStretchTakesItsPlacesAsIfItHadBeenPushed(Operation operation) {
        Random random = new Random(9);
        int inPlace = 0;
        for (int round = 0; round < ROUNDS; round++) {
            double[] run = random.doubles(2L * random.nextInt(5), 0, 10).sorted().toArray();
            double[] stretch = random.doubles(2, -1, 11).sorted().toArray();
            if (run.length > 0 && random.nextInt(4) == 0) {
                stretch[0] = run[random.nextInt(run.length)] + (random.nextInt(3) - 1) * 1e-11;
                stretch[1] = Math.max(stretch[0], stretch[1]);
            }
            Spans pushed = left(run);
            pushed.add(stretch[0], RIGHT, 4);
            pushed.add(stretch[1], RIGHT, 5);
            pushed.combine(operation, 1, 1 + run.length, 1);
            Spans combined = left(run);
            if (combined.combine(operation, 1, stretch[0], 4, stretch[1], 5, RIGHT, 1)) {
                inPlace++;
                assertThat(boundaries(combined)).as("round %d", round).isEqualTo(boundaries(pushed));
            } else {
                assertThat(boundaries(combined)).as("nothing changed in round %d", round).isEqualTo(boundaries(left(run)));
            }
        }
        assertThat(inPlace).as("mostly nothing lies in one place").isGreaterThan(ROUNDS / 2).isLessThan(ROUNDS);
    }

    /** With somebody else's boundary below. */
    private static Spans left(double[] run) {
        Spans spans = new Spans();
        spans.add(3, 0, 0);
        for (int i = 0; i < run.length; i++) {
            spans.add(run[i], LEFT, i);
        }
        return spans;
    }

    private static List<Boundary> boundaries(Spans spans) {
        List<Boundary> found = new ArrayList<>();
        for (int i = 0; i < spans.size(); i++) {
            found.add(new Boundary(spans.t(i), spans.part(i), spans.face(i)));
        }
        return found;
    }
}
