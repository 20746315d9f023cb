package cz.paprsek.render;

import static cz.paprsek.render.Scenes.empty;
import static cz.paprsek.render.Scenes.matte;
import static cz.paprsek.render.Scenes.middle;
import static cz.paprsek.render.Scenes.pixel;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures whose values can be worked out on paper. */
class ClosedFormTest {
    private static final double CLOSE = 1e-6;
    private static final Light AT_EYE = Light.at(0, 0, 5);

    @Test
    void anEmptySceneIsBackgroundEverywhere() {
        Image image = Renderer.render(empty().withBackground(Rgb.ofLinear(0.1, 0.2, 0.3)));
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                assertThat(pixel(image, x, y)).containsExactly(new double[] {0.1, 0.2, 0.3}, within(CLOSE));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.2, 0.8, 1})
    void aWhiteBallLitFromTheCameraShowsItsDiffusionInTheMiddle(double diffusion) {
        assertThat(middle(empty().plus(AT_EYE).plus(SceneObject.of(new Sphere(1)).madeOf(matte(1, diffusion))))).isCloseTo(diffusion, within(CLOSE));
    }

    @Test
    void diffuseLightFallsWithTheCosine() {
        // A wall at z = 0 lit from (3, 0, 4): the cosine at the origin is 4/5.
        Scene scene = empty().plus(Light.at(3, 0, 4)).plus(wall(0, matte(1, 1)));
        assertThat(middle(scene)).isCloseTo(0.8, within(CLOSE));
        assertThat(middle(empty().plus(Light.at(3, 0, -4)).plus(wall(0, matte(1, 1))))).as("lit from behind").isZero();
    }

    @ParameterizedTest
    @CsvSource({"1, 0.8", "2, 0.64", "10, 0.1073741824", "2.5, 0.5724334022", "0, 1"})
    void theHighlightIsTheCosineToThePowerOfTheShininess(double shininess, double expected) {
        // The mirrored eye ray is +z; the light stands at cosine 0.8 from it.
        Scene scene = empty().plus(Light.at(3, 0, 4)).plus(wall(0, matte(0, 0).withHighlight(1, shininess)));
        assertThat(middle(scene)).isCloseTo(expected, within(CLOSE));
    }

    @Test
    void ambientLightAddsColourOnceHoweverManyLights() {
        Scene scene = empty().withAmbient(Rgb.ofLinear(0.5, 0.5, 0.5)).plus(Light.at(0, 0, -9)).plus(Light.at(1, 0, -9)).plus(wall(0, matte(0.6, 0.3)));
        assertThat(middle(scene)).isCloseTo(0.3, within(CLOSE));
    }

    @Test
    void aMirrorShowsItsShareOfWhatItFaces() {
        Material mirror = matte(0, 0).withReflection(0.7);
        Scene scene = empty().withBackground(Rgb.ofLinear(0.5, 0.5, 0.5)).plus(wall(0, mirror));
        assertThat(middle(scene)).as("the background behind the eye").isCloseTo(0.35, within(CLOSE));
        Scene facing = empty().plus(Light.at(0, 0, 5)).plus(wall(0, mirror), wall(9, matte(0.5, 1)));
        assertThat(middle(facing)).as("a wall behind the eye").isCloseTo(0.35, within(CLOSE));
    }

    @ParameterizedTest
    @CsvSource({"1, 0.1", "2, 0.15", "3, 0.175", "4, 0.1875"})
    void facingMirrorsAddUpASeriesAsLongAsTheDepth(int depth, double expected) {
        // Each mirror gives 0.1 of its own and half of what it sees.
        Material mirror = matte(1, 0).withReflection(0.5);
        Scene scene = empty().withAmbient(Rgb.ofLinear(0.1, 0.1, 0.1)).withBackground(Rgb.WHITE)
                .withSettings(new RenderSettings(33, 25, depth, 1)).plus(wall(0, mirror), wall(9, mirror));
        assertThat(middle(scene)).isCloseTo(expected, within(CLOSE));
    }

    @Test
    void lightThroughGlassIsMultipliedAtEverySurface() {
        Material glass = matte(0, 0).withTransparency(0.5, 1.5);
        Scene lit = empty().plus(Light.at(3, 0, 4)).plus(wall(0, matte(1, 1)));
        SceneObject solid = SceneObject.of(new Block(new Vec3(1, -1, 1.8), new Vec3(2, 1, 2.2))).madeOf(glass);
        assertThat(middle(lit.plus(solid))).as("two surfaces of a solid").isCloseTo(0.8 * 0.25, within(CLOSE));
        SceneObject pane = SceneObject.of(new Rectangle(1, -1, 2, 1)).at(0, 0, 2).madeOf(glass);
        assertThat(middle(lit.plus(pane))).as("one surface of a pane").isCloseTo(0.8 * 0.5, within(CLOSE));
        assertThat(middle(lit.plus(pane.madeOf(matte(1, 1))))).as("an opaque pane").isZero();
        assertThat(middle(lit.plus(pane.at(0, 0, 4.5).madeOf(matte(1, 1))))).as("a pane behind the light").isCloseTo(0.8, within(CLOSE));
    }

    /** In whatever order they stand, to the last bit: the shares are multiplied from the smallest on. */
    @Test
    void lightThroughManyPanesIsTheProductOfTheirShares() {
        Scene lit = empty().plus(Light.at(3, 0, 4)).plus(wall(0, matte(1, 1)));
        Scene rising = lit;
        Scene falling = lit;
        double product = 1;
        for (int i = 0; i < 40; i++) {
            double share = 0.9 + 0.0025 * i;
            SceneObject pane = SceneObject.of(new Rectangle(0.5, -1, 3, 1)).madeOf(matte(0, 0).withTransparency(share, 1.5));
            rising = rising.plus(pane.at(0, 0, 1 + 0.05 * i));
            falling = falling.plus(pane.at(0, 0, 3 - 0.05 * i));
            product *= share;
        }
        assertThat(middle(rising)).isCloseTo(0.8 * product, within(CLOSE)).isEqualTo(middle(falling));
    }

    @Test
    void glassOfIndexOneAndFullTransparencyIsInvisible() {
        Scene scene = empty().withBackground(Rgb.ofLinear(0.2, 0.3, 0.4)).plus(AT_EYE).plus(wall(-3, matte(0.5, 1)
                .withPattern(new Pattern.Checkerboard(7, 7, Rgb.WHITE, Rgb.grey(50)))));
        Scene covered = scene.plus(SceneObject.of(new Sphere(1)).madeOf(matte(1, 0).withTransparency(1, 1)));
        assertThat(Scenes.difference(Renderer.render(scene), Renderer.render(covered), CLOSE)).isZero();
    }

    @ParameterizedTest
    @CsvSource({"20, 1.5", "45, 1.5", "60, 1.33", "60, 2.4"})
    void aGlassSlabShiftsARayAsSnellSays(double degrees, double index) {
        double theta = Math.toRadians(degrees);
        double thickness = 0.8;
        double shift = thickness * Math.sin(theta) * (1 - Math.cos(theta) / Math.sqrt(index * index - Math.sin(theta) * Math.sin(theta)));
        // The eye looks along −x sin − z cos at a slab between z = 0 and z = −0.8; far behind it a board of black and white halves, whose
        // border is put just on either side of where the shifted ray must arrive.
        Vec3 d = new Vec3(Math.sin(theta), 0, -Math.cos(theta));
        double arrives = 10 * Math.tan(theta) - shift / Math.cos(theta);
        SceneObject slab = SceneObject.of(new Block(new Vec3(-9, -9, -thickness), new Vec3(9, 9, 0)))
                .madeOf(matte(0, 0).withTransparency(1, index));
        for (double side : new double[] {-1e-6, 1e-6}) {
            double border = arrives + side;
            SceneObject board = SceneObject.of(new Rectangle(-50, -50, 50, 50)).at(border, 0, -10 - 0.0).madeOf(matte(1, 0)
                    .withPattern(new Pattern.Checkerboard(2, 1, Rgb.WHITE, Rgb.BLACK)));
            Scene scene = empty().withAmbient(Rgb.WHITE).withCamera(Camera.looking(new Vec3(0, 0, 0).minus(d.times(2)), d)).plus(slab, board);
            assertThat(middle(scene)).as("border %s of the ray", side < 0 ? "before" : "beyond").isCloseTo(side < 0 ? 0 : 1, within(CLOSE));
        }
    }

    @Test
    void totalReflectionCarriesTheWeightsOfBoth() {
        // The eye is in glass under its surface y = 0 and looks up at 60° from the normal: beyond the critical 41.8°.
        Material glass = matte(0, 0).withReflection(0.1).withTransparency(0.8, 1.5);
        Vec3 d = new Vec3(Math.sin(Math.toRadians(60)), Math.cos(Math.toRadians(60)), 0);
        Scene scene = empty().withBackground(Rgb.WHITE).withAmbient(Rgb.ofLinear(0.5, 0.5, 0.5))
                .withCamera(Camera.looking(new Vec3(0, -1, 0), d))
                .plus(SceneObject.of(new Plane()).madeOf(glass),
                        SceneObject.of(new Block(new Vec3(-99, -9, -99), new Vec3(99, -8, 99))).madeOf(matte(0.5, 0)));
        assertThat(middle(scene)).as("all of 0.25 from the floor, nothing from above").isCloseTo(0.9 * 0.25, within(CLOSE));
    }

    @Test
    void theEyeInsideGlassSeesTheWorldBentAsItLeaves() {
        // Inside a slab of index 1.5 a ray at 30° leaves at asin(0.75) = 48.59°.
        Vec3 d = new Vec3(0.5, 0, -Math.sqrt(0.75));
        double arrives = 0.5 * 0.5 / Math.sqrt(0.75) + 9.5 * Math.tan(Math.asin(0.75));
        SceneObject slab = SceneObject.of(new Block(new Vec3(-9, -9, -0.5), new Vec3(9, 9, 0.5))).madeOf(matte(0, 0).withTransparency(1, 1.5));
        for (double side : new double[] {-1e-6, 1e-6}) {
            SceneObject board = SceneObject.of(new Rectangle(-50, -50, 50, 50)).at(arrives + side, 0, -10).madeOf(matte(1, 0)
                    .withPattern(new Pattern.Checkerboard(2, 1, Rgb.WHITE, Rgb.BLACK)));
            Scene scene = empty().withAmbient(Rgb.WHITE).withCamera(Camera.looking(Vec3.ZERO, d)).plus(slab, board);
            assertThat(middle(scene)).isCloseTo(side < 0 ? 0 : 1, within(CLOSE));
        }
    }

    @ParameterizedTest
    @CsvSource({"-0.99, -0.99, 0", "0.99, 0.99, 0", "-0.99, 0.99, 1", "0.6, -0.99, 1", "1, 1, 0", "-1, -1, 0", "1, -1, 1"})
    void squaresOfABoardAlternateUpToItsVeryEdges(double x, double y, int odd) {
        // 4 × 4 squares from (−1, −1) to (1, 1); the one at the minimum corner is even, white.
        SceneObject board = SceneObject.of(new Rectangle(-1, -1, 1, 1)).madeOf(matte(1, 0).withPattern(new Pattern.Checkerboard(4, 4, Rgb.WHITE, Rgb.BLACK)));
        Scene scene = empty().withAmbient(Rgb.WHITE).withBackground(new Rgb(99, 99, 99)).withCamera(Camera.looking(new Vec3(x, y, 5), new Vec3(0, 0, -1)))
                .plus(board);
        assertThat(middle(scene)).isCloseTo(1 - odd, within(CLOSE));
    }

    @Test
    void aCheckerMovesAndTurnsWithItsObject() {
        Material cubes = matte(1, 0).withPattern(new Pattern.Checker(0.3, new Vec3(0.05, 0.05, 0.05), Rgb.WHITE, Rgb.grey(60)));
        SceneObject block = SceneObject.of(new Block(new Vec3(-1, -1, -1), Vec3.ONE)).madeOf(cubes);
        Scene scene = empty().withAmbient(Rgb.WHITE);
        Image still = Renderer.render(scene.plus(block));
        Image turned = Renderer.render(scene.plus(block.at(3, 0, 0).rotated(0, 90, 0))
                .withCamera(Camera.looking(new Vec3(8, 0, 0), new Vec3(-1, 0, 0))));
        assertThat(Scenes.difference(still, turned, CLOSE)).isZero();
        assertThat(Arrays.equals(still.toArgb(), new int[still.width() * still.height()])).isFalse();
    }

    private static SceneObject wall(double z, Material material) {
        return SceneObject.of(new Rectangle(-50, -50, 50, 50)).at(0, 0, z).madeOf(material);
    }
}
