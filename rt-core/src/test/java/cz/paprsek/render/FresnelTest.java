package cz.paprsek.render;

import static cz.paprsek.render.Scenes.empty;
import static cz.paprsek.render.Scenes.middle;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** How much surfaces mirror by the angle, against tables and closed forms. Everything around is white: what comes back is the share. */
class FresnelTest {
    private static final double CLOSE = 1e-6;
    private static final Material BLACK = Material.color(Rgb.BLACK).withDiffusion(0);

    /** A wall of which the middle is seen at an angle. */
    private static Scene wall(Material material, double degrees) {
        return empty().withBackground(Rgb.WHITE).plus(SceneObject.of(new Rectangle(-500, -1, 500, 1)).rotated(0, degrees, 0).madeOf(material));
    }

    private static Material lacquer(double index) {
        return BLACK.withReflection(1).withTransparency(0, index).withFresnel(Fresnel.TRUE);
    }

    /** ((n − 1)/(n + 1))², as in any table of optics. */
    @ParameterizedTest
    @CsvSource({"1, 0", "1.333, 0.0203733", "1.5, 0.04", "1.52, 0.0425800", "2.417, 0.1719688", "4, 0.36", "0.5, 0.1111111"})
    void straightAheadItIsTheSquareOfTheQuotient(double index, double expected) {
        assertThat(middle(wall(lacquer(index), 0))).isCloseTo(expected, within(CLOSE));
    }

    /** At Brewster's angle, tan θ = n, light of one polarisation is not mirrored, and of the other ((n² − 1)/(n² + 1))². */
    @ParameterizedTest
    @ValueSource(doubles = {1.333, 1.5, 2.417})
    void atBrewstersAngleOnePolarisationIsMissing(double index) {
        double other = (index * index - 1) / (index * index + 1);
        assertThat(middle(wall(lacquer(index), Math.toDegrees(Math.atan(index))))).isCloseTo(other * other / 2, within(CLOSE));
    }

    /** Worked out by the other form of the formulas, ½ sin²(θ₁ − θ₂)/sin²(θ₁ + θ₂) + ½ tan²(θ₁ − θ₂)/tan²(θ₁ + θ₂). */
    @ParameterizedTest
    @CsvSource({"30, 0.0415226", "45, 0.0502399", "60, 0.0891867", "75, 0.2530606", "85, 0.6127996"})
    void glassMirrorsMoreTheMoreItIsGrazed(double degrees, double expected) {
        assertThat(middle(wall(lacquer(1.5), degrees))).isCloseTo(expected, within(CLOSE));
    }

    @Test
    void aMetalMirrorsInItsColourAndWhiteWhenGrazed() {
        Material gold = Material.color(Rgb.ofLinear(0.5, 0.25, 0)).withDiffusion(0).withReflection(0.8).withFresnel(Fresnel.METAL);
        Image ahead = Renderer.render(wall(gold, 0));
        assertThat(Scenes.pixel(ahead, 16, 12)).containsExactly(new double[] {0.4, 0.2, 0}, within(CLOSE));
        // At 60°, (1 − ½)⁵ = 1/32.
        assertThat(Scenes.pixel(Renderer.render(wall(gold, 60)), 16, 12))
                .containsExactly(new double[] {0.8 * (0.5 + 0.5 / 32), 0.8 * (0.25 + 0.75 / 32), 0.8 / 32}, within(CLOSE));
    }

    /** What is not mirrored goes through: twice, in and out, (1 − F)². The rest that is mirrored within is beyond the depth. */
    @Test
    void whatIsNotMirroredGoesThrough() {
        Material glass = BLACK.withReflection(1).withTransparency(1, 1.5).withFresnel(Fresnel.TRUE);
        Scene scene = empty().withSettings(new RenderSettings(33, 25, 3, 1)).withBackground(Rgb.WHITE)
                .plus(SceneObject.of(new Block(new Vec3(-9, -9, -1), new Vec3(9, 9, 0))).madeOf(glass));
        assertThat(middle(scene)).isCloseTo(0.04 + 0.96 * 0.96, within(CLOSE));
    }

    /** A furnace: in white light all of it comes back, whatever way it takes. */
    @ParameterizedTest
    @CsvSource({"1, 1", "0.6, 1", "1, 0.7", "0.3, 1"})
    void asMuchLightComesBackAsThereIs(double reflection, double transparency) {
        Material glass = BLACK.withReflection(reflection).withTransparency(transparency, 1.5).withFresnel(Fresnel.TRUE);
        Image ball = Renderer.render(empty().withSettings(new RenderSettings(33, 25, 40, 1)).withBackground(Rgb.WHITE)
                .plus(SceneObject.of(new Sphere(1.5)).madeOf(glass)));
        for (int x = 0; x < 33; x++) {
            assertThat((double) ball.red(x, 12)).isLessThanOrEqualTo(1 + CLOSE);
        }
        assertThat((double) ball.red(16, 12)).as("all of it, if only the transparency is 1").isCloseTo(1, within(transparency == 1 ? 1e-4 : 1));
    }

    /** From 41.8° on, glass of 1.5 lets nothing out: kR + kT·(1 − kR), one ray. */
    @Test
    void whatIsTotallyReflectedHasTheWeightOfBoth() {
        Material glass = BLACK.withReflection(0.5).withTransparency(0.8, 1.5).withFresnel(Fresnel.TRUE);
        Scene inside = empty().withCamera(Camera.looking(new Vec3(0, 0, 0), new Vec3(1, 1, 0)))
                .plus(SceneObject.of(new Block(new Vec3(-9, -9, -9), new Vec3(9, 1, 9))).madeOf(glass));
        Encounter met = RenderScene.of(inside).explain(16, 12).rays().get(0).encounter().orElseThrow();
        assertThat(met.refracted()).isEmpty();
        assertThat(met.reflected().orElseThrow().weight().red()).isCloseTo(0.5 + 0.8 * 0.5, within(1e-15));
    }

    /** Both sides of a pane together, and all that goes to and fro between: 2F/(1 + F), nothing is bent. */
    @Test
    void aFlatFigureIsAPane() {
        Material glass = BLACK.withReflection(1).withTransparency(1, 1.5).withFresnel(Fresnel.TRUE);
        TracedRay ray = RenderScene.of(wall(glass, 30)).explain(16, 12).rays().get(0);
        Encounter met = ray.encounter().orElseThrow();
        double once = 0.0415226;
        assertThat(met.reflected().orElseThrow().weight().red()).isCloseTo(2 * once / (1 + once), within(CLOSE));
        assertThat(met.refracted().orElseThrow().weight().red()).isCloseTo(1 - 2 * once / (1 + once), within(CLOSE));
        assertThat(met.refracted().orElseThrow().direction()).isEqualTo(ray.direction());
    }
}
