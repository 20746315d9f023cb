package cz.paprsek.render.sample;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class TurnTest {
    private final Turn turn = new Turn();

    @Test
    void cosineAndSineAreThoseOfStrictMath() {
        for (int i = -4000; i <= 12_000; i++) {
            double share = i / 4001.0;
            turn.by(share);
            // The angle itself is rounded, by half a unit in the last place of 6π at most.
            assertThat(turn.cosine).as("cosine of %s", share).isCloseTo(StrictMath.cos(2 * Math.PI * share), within(3e-15));
            assertThat(turn.sine).as("sine of %s", share).isCloseTo(StrictMath.sin(2 * Math.PI * share), within(3e-15));
            assertThat(turn.cosine * turn.cosine + turn.sine * turn.sine).as("length at %s", share).isCloseTo(1, within(9e-16));
        }
    }

    @Test
    void smallSharesAreExactToTheLastBits() {
        for (int i = 1; i <= 1000; i++) {
            double share = i / 8001.0;
            turn.by(share);
            assertThat(turn.cosine).as("cosine of %s", share).isCloseTo(StrictMath.cos(2 * Math.PI * share), within(4e-16));
            assertThat(turn.sine).as("sine of %s", share).isCloseTo(StrictMath.sin(2 * Math.PI * share), within(4e-16));
        }
    }

    @Test
    void noTurnAndHalfATurnAreExact() {
        turn.by(0);
        assertThat(turn.cosine).isEqualTo(1);
        assertThat(turn.sine).isZero();
        turn.by(0.5);
        assertThat(turn.cosine).isEqualTo(-1);
        assertThat(turn.sine).isZero();
    }
}
