package cz.paprsek.shape.outline;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WayTest {
    private static final double ROUNDING = 1e-9;

    private static void isAt(Way way, double share, double x, double y, double dx, double dy) {
        double[] at = way.at(share);
        assertThat(at[0]).as("x at %s", share).isEqualTo(x, within(ROUNDING));
        assertThat(at[1]).as("y at %s", share).isEqualTo(y, within(ROUNDING));
        assertThat(at[2]).as("dx at %s", share).isEqualTo(dx, within(ROUNDING));
        assertThat(at[3]).as("dy at %s", share).isEqualTo(dy, within(ROUNDING));
    }

    /** A quarter of a circle, by one piece, either way round. */
    @ParameterizedTest
    @CsvSource({"0, 5, 0, 180, 90", "1, 0, 5, -90, 0"})
    void onePieceBeginsWhereItIsWritten(int sweep, double middleX, double middleY, double from, double to) {
        Way way = Way.of("animate", "M 0 0 A 5 5 0 0 " + sweep + " 5 5");
        assertThat(way.length()).isEqualTo(5 * Math.PI / 2, within(ROUNDING));
        for (double share = 0; share <= 1; share += 0.125) {
            double angle = Math.toRadians(from + share * (to - from));
            double sign = Math.signum(to - from);
            isAt(way, share, middleX + 5 * Math.cos(angle), middleY + 5 * Math.sin(angle), -sign * Math.sin(angle), sign * Math.cos(angle));
        }
    }

    /** A quarter of a circle, and back by its chord. */
    @ParameterizedTest
    @CsvSource({"0, 1, 0, 180, 90", "1, 0, 1, -90, 0"})
    void aClosedWayOfTwoPiecesRunsAsItIsWritten(int sweep, double middleX, double middleY, double from, double to) {
        Way way = Way.of("animate", "M0 0 A 1 1 0 0 " + sweep + " 1 1 Z");
        double arc = Math.PI / 2;
        assertThat(way.length()).isEqualTo(arc + Math.sqrt(2), within(ROUNDING));
        for (double far = 0.1; far < way.length(); far += 0.2) {
            double angle = Math.toRadians(from + far / arc * (to - from));
            double sign = Math.signum(to - from);
            double left = (far - arc) / Math.sqrt(2);
            if (far < arc) {
                isAt(way, far / way.length(), middleX + Math.cos(angle), middleY + Math.sin(angle), -sign * Math.sin(angle), sign * Math.cos(angle));
            } else {
                isAt(way, far / way.length(), 1 - left, 1 - left, -Math.sqrt(0.5), -Math.sqrt(0.5));
            }
        }
        // It is closed: one goes around again.
        assertThat(way.at(1.25)).containsExactly(way.at(0.25), within(ROUNDING));
    }

    @Test
    void anOutlineOfTwoPiecesGoesAroundOnce() {
        Outline outline = Outline.of("extrude", "M0 0 A 1 1 0 0 0 1 1 Z", "");
        double arc = Math.PI / 2 / (Math.PI / 2 + Math.sqrt(2));
        assertThat(outline.isReversed(0)).isTrue();
        assertThat(outline.isReversed(1)).isFalse();
        assertThat(outline.around(0, 1)).isEqualTo(0, within(1e-4));
        assertThat(outline.around(0, 0)).isEqualTo(arc, within(1e-4));
        assertThat(outline.around(1, 0)).isEqualTo(arc, within(1e-4));
        assertThat(outline.polygons(1e-3).get(0)).first().satisfies(corner -> assertThat(corner.length()).isZero());
    }

    /** There the direction is that to the next point of the curve that lies elsewhere. */
    @ParameterizedTest
    @CsvSource({"0 0 1 2 3 0, 0, 1, 2", "1 2 3 0 3 0, 1, 2, -2", "0 0 3 0 3 0, 0, 1, 0", "0 0 3 0 3 0, 1, 1, 0", "0 0 0 0 3 4, 0, 3, 4", "3 4 3 4 3 4, 1, 3, 4"})
    void thereIsADirectionWhereAHandleLiesOnItsEnd(String handles, double share, double dx, double dy) {
        double[] at = Way.of("animate", "M 0 0 C " + handles).at(share);
        double length = Math.sqrt(dx * dx + dy * dy);
        assertThat(at[2]).isEqualTo(dx / length, within(1e-3));
        assertThat(at[3]).isEqualTo(dy / length, within(1e-3));
        assertThat(at[2] * at[2] + at[3] * at[3]).isEqualTo(1, within(ROUNDING));
    }

    @Test
    void aStairIsClimbedStepByStep() {
        Way way = Way.of("animate", "M 0 0" + " h 1 v 1".repeat(10_000));
        assertThat(way.length()).isEqualTo(20_000, within(1e-6));
        for (int i = 0; i < 20_000; i += 7) {
            isAt(way, (i + 0.5) / 20_000, Math.ceil(i / 2.0) + (i % 2 == 0 ? 0.5 : 0), Math.floor(i / 2.0) + (i % 2 == 0 ? 0 : 0.5), i % 2 == 0 ? 1 : 0, i % 2 == 0 ? 0 : 1);
        }
    }

    @Test
    void whatIsNoWayIsToldInASentence() {
        assertThatIllegalArgumentException().isThrownBy(() -> Way.of("animate", "M 0 0" + " h 1 v 1".repeat(10_000) + " h 1"))
                .withMessage("animate path must have at most 20000 pieces, but has 20001");
        assertThatIllegalArgumentException().isThrownBy(() -> Way.of("animate", "M0 0 L1e-200 0"))
                .withMessage("animate path leads nowhere: it is too short to have a length");
        assertThatIllegalArgumentException().isThrownBy(() -> Way.of("animate", "M0 0"))
                .withMessage("animate path must be one curve, but leads nowhere");
    }

    @Test
    void aPieceThatAddsNothingToTheLengthIsAWayToo() {
        assertThat(Way.of("animate", "M0 0 H1 V1e-20").at(1)).containsExactly(1, 1e-20, 0, 1);
        assertThat(Way.of("animate", "M0 0 H1 V1e-200").at(1)).containsExactly(1, 1e-200, 0, 1);
    }
}
