package cz.paprsek.render;

import static cz.paprsek.render.Scenes.empty;
import static cz.paprsek.render.Scenes.matte;
import static cz.paprsek.render.Scenes.middle;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.Pattern;
import cz.paprsek.material.Pattern.Lay;
import cz.paprsek.material.Pattern.Stop;
import cz.paprsek.material.Pattern.Stops;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.texture.LatticeNoise;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Rectangle;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Patterns, seen on a wall at z = 0: white is 1, black is 0. Noise is compared with POV-Ray's in the cross-check. */
class PatternTest {
    private static final double CLOSE = 1e-6;
    private static final Pattern.Colors BLACK_TO_WHITE = new Pattern.TwoColors(Rgb.BLACK, Rgb.WHITE);

    private static double seen(Pattern pattern, double x, double y) {
        Scene scene = empty().withAmbient(Rgb.WHITE).withCamera(Camera.looking(new Vec3(x, y, 5), new Vec3(0, 0, -1)))
                .plus(SceneObject.of(new Rectangle(-50, -50, 50, 50)).madeOf(matte(1, 0).withPattern(pattern)));
        return middle(scene);
    }

    @ParameterizedTest
    @CsvSource({"-3, 0", "0, 0", "0.25, 0.25", "0.8, 0.8", "1, 1", "7, 1"})
    void aGradientRisesFromOneColourToTheOther(double y, double white) {
        assertThat(seen(new Pattern.Gradient(BLACK_TO_WHITE, Lay.NONE), 5, y)).isCloseTo(white, within(CLOSE));
        assertThat(seen(new Pattern.Gradient(BLACK_TO_WHITE, Lay.NONE.withRotation(new Vec3(0, 0, 90))), -y, 5)).as("turned to the left").isCloseTo(white, within(CLOSE));
        assertThat(seen(new Pattern.Gradient(BLACK_TO_WHITE, Lay.scaled(4).withPosition(new Vec3(0, 1, 0))), 5, 4 * y + 1)).as("moved and larger").isCloseTo(white, within(CLOSE));
    }

    @ParameterizedTest
    @CsvSource({"0.1, 0.2", "0.2, 0.2", "0.3, 0.5", "0.4, 0.8", "0.5, 0.6", "0.59999, 0.4", "0.6, 1", "0.7, 0", "0.99, 0"})
    void betweenStopsColoursAreMixedInLinearLight(double y, double white) {
        Pattern gradient = new Pattern.Gradient(Stops.of(new Stop(0.2, grey(0.2)), new Stop(0.4, grey(0.8)), new Stop(0.6, grey(0.4)), new Stop(0.6, grey(1)),
                new Stop(0.7, grey(0))), Lay.NONE);
        assertThat(seen(gradient, 0, y)).isCloseTo(white, within(1e-4));
    }

    private static Rgb grey(double light) {
        return Rgb.ofLinear(light, light, light);
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "0.29, 1", "0.31, 0", "0.61, 1", "-0.01, 0", "-0.31, 1"})
    void stripesTakeTurns(double x, double white) {
        assertThat(seen(new Pattern.Stripes(0.3, Rgb.WHITE, Rgb.BLACK, Lay.NONE), x, 3)).isCloseTo(white, within(CLOSE));
    }

    /** Bricks of 1 × 0.5 with 0.1 of mortar: the first course begins at 0, the second half a brick beyond. */
    @ParameterizedTest
    @CsvSource({"0.01, 0.01, 1", "0.89, 0.01, 1", "0.91, 0.01, 0", "0.5, 0.39, 1", "0.5, 0.41, 0", "0.39, 0.6, 1", "0.41, 0.6, 0", "0.51, 0.6, 1", "-0.05, 0.2, 0", "-0.15, 0.2, 1",
        "0.2, -0.05, 0", "0.2, -0.15, 1"})
    void bricksOfACourseLieHalfABrickBeyondThoseBelow(double x, double y, double white) {
        Pattern bricks = new Pattern.Brick(new Vec3(1, 0.5, 0.5), 0.1, Rgb.WHITE, Rgb.BLACK, Lay.NONE);
        assertThat(seen(bricks, x, y)).isCloseTo(white, within(CLOSE));
    }

    @ParameterizedTest
    @CsvSource({"0.1, 0.1, 1", "0.6, 0.1, 0", "0.1, 0.3, 0", "0.6, 0.3, 1"})
    void boxesOfACheckerHaveThreeSizes(double x, double y, double white) {
        assertThat(seen(new Pattern.Checker(new Vec3(0.5, 0.25, 9), Vec3.ZERO, Rgb.WHITE, Rgb.BLACK, Lay.NONE), x, y)).isCloseTo(white, within(CLOSE));
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "0.125, 0.5", "0.25, 1", "0.375, 0.5", "-0.125, 0.5", "0.5, 0"})
    void marbleWithoutTurbulenceRisesAndFallsEvenly(double x, double white) {
        assertThat(seen(new Pattern.Marble(2, 0, 1, 0, BLACK_TO_WHITE, Lay.NONE), x, 1)).isCloseTo(white, within(CLOSE));
    }

    @ParameterizedTest
    @CsvSource({"0.3, 0, 0.6", "0, 0.3, 0", "0.6, 7, 0.2", "-0.6, 7, 0.2"})
    void woodWithoutTurbulenceHasRingsAboutTheYAxis(double x, double y, double white) {
        assertThat(seen(new Pattern.Wood(2, 0, 1, 0, BLACK_TO_WHITE, Lay.NONE), x, y)).isCloseTo(white, within(CLOSE));
    }

    @Test
    void noiseIsNothingAtTheCornersOfItsLattice() {
        for (int seed = 0; seed < 50; seed++) {
            assertThat(seen(new Pattern.Noise(5, seed, BLACK_TO_WHITE, Lay.NONE), seed - 25, seed % 7)).isCloseTo(0.5, within(CLOSE));
            assertThat(seen(new Pattern.Granite(5, seed, BLACK_TO_WHITE, Lay.NONE), seed - 25, seed % 7)).isCloseTo(0, within(CLOSE));
        }
    }

    @Test
    void noiseStaysWithinItsBoundsAndRepeatsEvery289() {
        LatticeNoise noise = new LatticeNoise(1, 7);
        Random random = new Random(1);
        double most = 0;
        double sum = 0;
        for (int i = 0; i < 100_000; i++) {
            double x = random.nextInt(1 << 20) * 0x1p-12 - 128;
            double y = random.nextInt(1 << 20) * 0x1p-12 - 128;
            double z = random.nextInt(1 << 20) * 0x1p-12 - 128;
            double value = noise.sum(x, y, z);
            assertThat(noise.sum(x + 289, y - 578, z + 289)).isEqualTo(value);
            most = Math.max(most, Math.abs(value));
            sum += value;
        }
        assertThat(most).isBetween(0.7, 1.05);
        assertThat(sum / 100_000).isCloseTo(0, within(0.01));
    }

    /** Slopes on both sides of a lattice plane are the same: nothing shows where cubes meet. */
    @Test
    void noiseIsSmoothWhereCubesMeet() {
        LatticeNoise noise = new LatticeNoise(1, 3);
        for (int i = 0; i < 1000; i++) {
            double y = i * 0.37;
            double z = i * 0.11;
            double slope = (noise.sum(i, y, z) - noise.sum(i - 1e-5, y, z)) / 1e-5;
            assertThat((noise.sum(i + 1e-5, y, z) - noise.sum(i, y, z)) / 1e-5).isCloseTo(slope, within(1e-3));
        }
    }

    @ParameterizedTest
    @CsvSource({"1e45", "-1e45", "1e300", "Infinity", "NaN"})
    void noiseHasAValueHoweverFarAway(double far) {
        assertThat(new LatticeNoise(12, 1_000_000).sum(far, far, -far)).isFinite();
        assertThat(new LatticeNoise(12, 1_000_000).sumOfSizes(far, 0, 0)).isFinite();
    }

    @Test
    void twoSeedsAreTwoNoises() {
        assertThat(new LatticeNoise(1, 0).sum(0.3, 0.4, 0.5)).isNotEqualTo(new LatticeNoise(1, 1).sum(0.3, 0.4, 0.5));
    }

    @Test
    void stopsComeInRisingOrderAndAreTwoAtLeast() {
        assertThatThrownBy(() -> Stops.of(new Stop(0.5, Rgb.WHITE), new Stop(0.4, Rgb.WHITE))).hasMessage("stops must be in rising order, but after 0.5 comes 0.4");
        assertThatThrownBy(() -> Stops.of(new Stop(0.5, Rgb.WHITE))).hasMessage("a pattern must have from 2 to 256 stops, but has 1");
    }
}
