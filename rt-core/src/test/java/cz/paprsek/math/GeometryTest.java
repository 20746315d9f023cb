package cz.paprsek.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Points, boxes and angles, by hand and by the laws they obey. */
class GeometryTest {
    private static final Vec3 A = new Vec3(2, -3, 5);
    private static final Vec3 B = new Vec3(7, 11, -13);
    private static final Bounds BOX = new Bounds(-1, 2, -3, 4, 5, -2);

    private final Random random = new Random(8);

    @Test
    void vectorsAreAddedAndMultipliedAsByHand() {
        assertThat(A.plus(B)).isEqualTo(new Vec3(9, 8, -8));
        assertThat(A.minus(B)).isEqualTo(new Vec3(-5, -14, 18));
        assertThat(A.times(-2)).isEqualTo(new Vec3(-4, 6, -10));
        assertThat(A.negated()).isEqualTo(new Vec3(-2, 3, -5));
        assertThat(A.dot(B)).isEqualTo(14 - 33 - 65);
        assertThat(A.cross(B)).isEqualTo(new Vec3(-16, 61, 43));
        assertThat(A.cross(B).dot(A)).isZero();
        assertThat(Vec3.X.cross(Vec3.Y)).isEqualTo(Vec3.Z);
    }

    @Test
    void lengthsNeitherOverflowNorVanish() {
        assertThat(new Vec3(2, 3, 6).length()).isEqualTo(7);
        assertThat(new Vec3(2e200, 3e200, 6e200).length()).isCloseTo(7e200, within(1e185));
        assertThat(new Vec3(2e-200, 3e-200, 6e-200).length()).isCloseTo(7e-200, within(1e-215));
        assertThat(new Vec3(-3e-200, 0, 4e-200).normalized().minus(new Vec3(-0.6, 0, 0.8)).length()).isLessThan(1e-15);
        assertThatIllegalArgumentException().isThrownBy(Vec3.ZERO::normalized);
    }

    @Test
    void aBoxKnowsWhatItHolds() {
        assertThat(BOX.volume()).isEqualTo(15);
        assertThat(BOX.magnitude()).isEqualTo(5);
        assertThat(BOX.isFinite()).isTrue();
        assertThat(BOX.isEmpty()).isFalse();
        assertThat(BOX.contains(new Vec3(-1, 5, -2.5))).as("a box is closed").isTrue();
        for (Vec3 out : new Vec3[] {new Vec3(-1.1, 3, -2.5), new Vec3(4.1, 3, -2.5), new Vec3(0, 1.9, -2.5), new Vec3(0, 5.1, -2.5),
            new Vec3(0, 3, -3.1), new Vec3(0, 3, -1.9)}) {
            assertThat(BOX.contains(out)).isFalse();
        }
        assertThat(BOX.grown(2)).isEqualTo(new Bounds(-3, 0, -5, 6, 7, 0));
    }

    @Test
    void scalingAndMovingAtOnceHasTheVeryNumbersOfOneAfterTheOther() {
        for (Vec3 by : new Vec3[] {A, B, Vec3.ZERO, new Vec3(-0.0, 1e-300, -1e300)}) {
            for (Vec3 factors : new Vec3[] {Vec3.ONE, A, B.negated()}) {
                assertThat(Affine.scalingAndMoving(factors, by)).isEqualTo(Affine.translation(by).after(Affine.scaling(factors)));
            }
        }
    }

    @Test
    void theEmptyBoxAndTheBoxOfAllAreNeutral() {
        assertThat(Bounds.EMPTY.isEmpty()).isTrue();
        assertThat(Bounds.EMPTY.volume()).isZero();
        assertThat(Bounds.EMPTY.magnitude()).isZero();
        assertThat(Bounds.EMPTY.grown(3)).isEqualTo(Bounds.EMPTY);
        assertThat(Bounds.EMPTY.transformed(Affine.translation(A))).isEqualTo(Bounds.EMPTY);
        assertThat(BOX.union(Bounds.EMPTY)).isEqualTo(BOX);
        assertThat(BOX.intersection(Bounds.ALL)).isEqualTo(BOX);
        assertThat(Bounds.ALL.transformed(Affine.rotation(A))).isEqualTo(Bounds.ALL);
        assertThat(BOX.intersection(BOX.transformed(Affine.translation(new Vec3(0, 0, 2))))).isEqualTo(Bounds.EMPTY);
        for (Bounds open : new Bounds[] {new Bounds(0, 0, 0, Double.POSITIVE_INFINITY, 1, 1),
            new Bounds(0, Double.NEGATIVE_INFINITY, 0, 1, 1, 1), new Bounds(0, 0, 0, 1, 1, Double.POSITIVE_INFINITY)}) {
            assertThat(open.isFinite()).isFalse();
        }
    }

    @Test
    void aPaddedBoxIsLargerThanRoundingAndNotMuch() {
        Bounds padded = new Bounds(1000, 1, 1, 1001, 2, 2).padded();
        assertThat(1000 - padded.minX()).isBetween(0.9e-9, 1.2e-9);
        assertThat(padded.maxY() - 2).isBetween(0.9e-9, 1.2e-9);
    }

    @Test
    void aMappedBoxTouchesTheMappedCorners() {
        for (int i = 0; i < 1000; i++) {
            Affine map = Affine.translation(vector(9)).after(Affine.rotation(vector(180))).after(Affine.scaling(vector(2)));
            Bounds box = Bounds.of(vector(3), vector(3));
            Bounds corners = Bounds.EMPTY;
            for (int k = 0; k < 8; k++) {
                Vec3 corner = map.point(new Vec3((k & 1) == 0 ? box.minX() : box.maxX(), (k & 2) == 0 ? box.minY() : box.maxY(),
                        (k & 4) == 0 ? box.minZ() : box.maxZ()));
                corners = corners.union(Bounds.of(corner, corner));
            }
            Bounds mapped = box.transformed(map);
            assertThat(mapped.grown(1e-12).intersection(corners)).isEqualTo(corners);
            assertThat(corners.grown(1e-12).intersection(mapped)).isEqualTo(mapped);
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 1", "90, 1, 0", "180, 0, -1", "270, -1, 0", "360, 0, 1", "450, 1, 0", "-90, -1, 0", "-180, 0, -1", "36000090, 1, 0"})
    void quarterTurnsAreExact(double degrees, double sine, double cosine) {
        assertThat(Angles.sin(degrees)).isEqualTo(sine);
        assertThat(Angles.cos(degrees)).isEqualTo(cosine);
    }

    @ParameterizedTest
    @ValueSource(doubles = {30, 100, 200, 300, -45, 1e-3, 765.5})
    void anglesAreInDegreesAndRepeatAfterAFullTurn(double degrees) {
        assertThat(Angles.sin(degrees)).isCloseTo(Math.sin(degrees * Math.PI / 180), within(1e-14));
        assertThat(Angles.cos(degrees)).isCloseTo(Math.cos(degrees * Math.PI / 180), within(1e-14));
        assertThat(Angles.tan(degrees)).isCloseTo(Math.tan(degrees * Math.PI / 180), within(1e-13));
        assertThat(Angles.cos(degrees + 720)).isCloseTo(Angles.cos(degrees), within(1e-14));
        assertThat(Angles.sin(degrees - 360)).isCloseTo(Angles.sin(degrees), within(1e-14));
    }

    private Vec3 vector(double size) {
        return new Vec3(size * (2 * random.nextDouble() - 1), size * (2 * random.nextDouble() - 1), size * (2 * random.nextDouble() - 1));
    }

    @Test
    void aSimilarityIsAStretchAlikeInAllDirections() {
        Affine turn = Affine.rotation(new Vec3(20, -35, 70));
        assertThat(turn.uniformScale()).isCloseTo(1, within(1e-15));
        assertThat(turn.after(Affine.scaling(Vec3.ONE.times(3))).uniformScale()).isCloseTo(3, within(1e-14));
        assertThat(Affine.scaling(new Vec3(2, 2, 2 + 1e-12)).uniformScale()).isZero();
        assertThat(Affine.scaling(new Vec3(2, 2 + 1e-12, 2)).uniformScale()).isZero();
        for (int pair = 0; pair < 3; pair++) {
            // Columns as long as one another, two of which lean towards each other by 1e-12.
            double lean = 1e-12;
            double[] m = {1, 0, 0, 0, 1, 0, 0, 0, 1};
            m[pair == 0 ? 1 : pair == 1 ? 2 : 5] = lean;
            assertThat(new Affine(m[0], m[1], m[2], 5, m[3], m[4], m[5], 6, m[6], m[7], m[8], 7).uniformScale()).as("pair %s", pair).isZero();
        }
    }

    @Test
    void onlyStretchesAlongTheAxesKeepTheirDirections() {
        assertThat(Affine.scaling(new Vec3(1, 2, 3)).turns()).isFalse();
        assertThat(Affine.translation(A).turns()).isFalse();
        for (int i = 0; i < 9; i++) {
            double[] m = {1, 0, 0, 0, 2, 0, 0, 0, 3};
            m[i] = i % 4 == 0 ? -1 : 1e-9;
            assertThat(new Affine(m[0], m[1], m[2], 0, m[3], m[4], m[5], 0, m[6], m[7], m[8], 0).turns()).as("number %s", i).isTrue();
        }
    }

    /** Powers of two change no digit, however long they make one axis and short another. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 130, -130, 300})
    void theWayBackIsAsExactForLongAxesAsForShortOnes(int power) {
        Affine turn = Affine.rotation(new Vec3(10, 20, 30));
        double length = Math.scalb(1.0, power);
        Affine back = turn.after(Affine.scaling(new Vec3(length, 1, 1 / length))).inverse();
        assertThat(back.point(A)).isEqualTo(Affine.scaling(new Vec3(1 / length, 1, length)).point(turn.inverse().point(A)));
        double longer = Math.scalb(1.0, 2 * power);
        assertThat(Affine.scaling(Vec3.ONE.times(longer)).inverse().point(A)).as("though nobody can say how much room that takes").isEqualTo(A.times(1 / longer));
    }
}
