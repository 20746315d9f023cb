package cz.paprsek.render;

import static cz.paprsek.render.Scenes.empty;
import static cz.paprsek.render.Scenes.matte;
import static cz.paprsek.render.Scenes.pixel;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.LightTerm.ShadowRay;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What substances take of light, and what surfaces give of their own: by the law of Bouguer, Lambert and Beer. */
class AbsorptionTest {
    private static final Offset<Double> CLOSE = within(1e-6);
    /** Bends nothing; c = (½, 0, 1), D = 2: a way d leaves exp(−d/4), exp(−d/2), 1. */
    private static final Material TINTED = matte(0, 0).withTransparency(1, 1).withAttenuation(Rgb.ofLinear(0.5, 0, 1), 2);

    private static SceneObject slab(double from, double to, Material material) {
        return SceneObject.of(new Block(new Vec3(-50, -50, from), new Vec3(50, 50, to))).madeOf(material);
    }

    private static double[] left(double way) {
        return new double[] {Math.exp(-way / 4), Math.exp(-way / 2), 1};
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.25, 1, 3})
    void aSlabLeavesWhatItsThicknessLeaves(double thickness) {
        Scene scene = empty().withBackground(Rgb.WHITE).plus(slab(-thickness, 0, TINTED));
        assertThat(pixel(Renderer.render(scene), 16, 12)).containsExactly(left(thickness), CLOSE);
    }

    /** A hole in the middle takes nothing, and what is in it takes its own. */
    @Test
    void onlyWhatIsInsideTakes() {
        Scene hollow = empty().withBackground(Rgb.WHITE).plus(SceneObject.of(Csg.difference(Operand.of(new Sphere(2)), Operand.of(new Sphere(1.5)))).madeOf(TINTED));
        assertThat(pixel(Renderer.render(hollow), 16, 12)).containsExactly(left(1), CLOSE);
        Material other = matte(0, 0).withTransparency(1, 1).withAttenuation(Rgb.ofLinear(1, 1, 0.5), 1);
        Scene within = empty().withBackground(Rgb.WHITE).plus(slab(-3, 0, TINTED), slab(-2, -1, other));
        assertThat(pixel(Renderer.render(within), 16, 12)).as("where two overlap the one entered last counts")
                .containsExactly(new double[] {Math.exp(-0.5), Math.exp(-1), Math.exp(-0.5)}, CLOSE);
    }

    @Test
    void theEyeInsideSeesThroughTheRestOnly() {
        Scene scene = empty().withCamera(Camera.looking(new Vec3(0, 0, 0), new Vec3(0, 0, -1))).withBackground(Rgb.WHITE).plus(slab(-3, 9, TINTED));
        assertThat(pixel(Renderer.render(scene), 16, 12)).containsExactly(left(3), CLOSE);
    }

    @Test
    void aSeaWithoutEndIsBlackButForWhatItDoesNotTake() {
        Scene scene = empty().withBackground(Rgb.WHITE).plus(SceneObject.of(new Plane()).rotated(90, 0, 0).madeOf(TINTED));
        assertThat(pixel(Renderer.render(scene), 16, 12)).containsExactly(new double[] {0, 0, 1}, CLOSE);
    }

    /** The lamp stands straight above the point that is seen: its light comes through a slab one unit thick, once. */
    @Test
    void shadowsHaveTheColourOfWhatLightComesThrough() {
        Material wall = matte(1, 1);
        Scene scene = empty().plus(Light.at(0, 0, 50)).plus(SceneObject.of(new Rectangle(-9, -9, 9, 9)).madeOf(wall), slab(6, 7, TINTED));
        assertThat(pixel(Renderer.render(scene), 16, 12)).containsExactly(left(1), CLOSE);
        ShadowRay ray = RenderScene.of(scene).explain(16, 12).rays().get(0).encounter().orElseThrow().lights().get(0).ray();
        assertThat(ray.visibility()).isEqualTo(1);
        assertThat(ray.absorptions()).singleElement().satisfies(one -> {
            assertThat(one.length()).isCloseTo(1, within(1e-9));
            assertThat(one.left()).isEqualTo(ray.left());
        });
    }

    /** Under water: to the wall, and from the lamp down to it. */
    @Test
    void whatIsInsideIsLitThroughIt() {
        Scene scene = empty().plus(Light.at(0, 0, 50)).plus(SceneObject.of(new Rectangle(-9, -9, 9, 9)).madeOf(matte(1, 1)), slab(-1, 2, TINTED));
        assertThat(pixel(Renderer.render(scene), 16, 12)).containsExactly(left(4), CLOSE);
    }

    @Test
    void whatIsMirroredWithinIsWeakenedOnItsWayToo() {
        Material mirroring = TINTED.withReflection(0.5);
        Scene scene = empty().withBackground(Rgb.WHITE).withSettings(empty().settings().withSize(33, 25)).plus(slab(-1, 0, mirroring));
        // ½ + Σ: out at the back after one way, at the front after two, at the back after three …, each time half of it is mirrored.
        double[] expected = new double[3];
        for (int i = 0; i < 3; i++) {
            double once = left(1)[i];
            double light = 0.5;
            // Levels 2 to 8: what is inside lets all out and mirrors half.
            double inside = 1;
            for (int level = 2; level <= 7; level++) {
                inside *= once;
                light += inside;
                inside *= 0.5;
            }
            expected[i] = light;
        }
        assertThat(pixel(Renderer.render(scene), 16, 12)).containsExactly(expected, CLOSE);
    }

    @Test
    void aSurfaceShinesWhateverFallsOnIt() {
        Material lamp = matte(0.5, 0.5).withEmission(Rgb.ofLinear(1, 0.5, 0), 3);
        Scene dark = empty().plus(slab(-1, 0, lamp));
        assertThat(pixel(Renderer.render(dark), 16, 12)).containsExactly(new double[] {3, 1.5, 0}, CLOSE);
        Scene lit = dark.plus(Light.at(0, 0, 5)).plus(slab(2, 3, TINTED));
        double[] through = left(1);
        assertThat(pixel(Renderer.render(lit), 16, 12)).as("own light through one slab, the lamp's through two")
                .containsExactly(new double[] {(3 + 0.25 * through[0]) * through[0], (1.5 + 0.25 * through[1]) * through[1], 0.25}, CLOSE);
    }

    @Test
    void theTermsAreThoseOfThePicture() {
        Scene scene = empty().withAmbient(Rgb.grey(80)).plus(Light.at(3, 4, 9)).plus(slab(-9, -2, matte(0.4, 0.6).withEmission(new Rgb(200, 100, 50), 0.7)),
                SceneObject.of(new Sphere(1)).madeOf(TINTED.withTransparency(0.9, 1.5)));
        TracedRay inside = RenderScene.of(scene).explain(16, 12).rays().get(0).encounter().orElseThrow().refracted().orElseThrow();
        assertThat(inside.absorbed().orElseThrow().length()).isCloseTo(2, within(1e-9));
        LinearRgb sum = inside.encounter().orElseThrow().terms().stream().reduce(LinearRgb::plus).orElseThrow();
        assertThat(inside.light()).isEqualTo(inside.absorbed().orElseThrow().left().times(sum));
    }
}
