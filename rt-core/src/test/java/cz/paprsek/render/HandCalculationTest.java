package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.Encounter.Refraction;
import cz.paprsek.render.explain.LightTerm.ShadowRay;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

/** Pixels whose every figure can be worked out with a pencil: all angles are those of the triangle 3-4-5. */
class HandCalculationTest {
    private static final Offset<Double> EXACT = Offset.offset(1e-9);

    private static Scene scene(Vec3 eye, Vec3 view, int maxDepth) {
        Vec3 up = view.x() == 0 ? Vec3.Y : Vec3.Z;
        return Scene.EMPTY.withSettings(new RenderSettings(1, 1, maxDepth, 1)).withCamera(Camera.looking(eye, view).withUp(up));
    }

    private static Rgb grey(double linear) {
        return Rgb.ofLinear(linear, linear, linear);
    }

    private static TracedRay onlyPixel(Scene scene) {
        TracedRay ray = RenderScene.of(scene).explain(0, 0).rays().get(0);
        Image image = Renderer.render(scene);
        assertThat(image.red(0, 0)).isEqualTo((float) ray.light().red());
        return ray;
    }

    private static void assertIsAt(Vec3 found, double x, double y, double z) {
        assertThat(found.minus(new Vec3(x, y, z)).length()).as("%s", found).isLessThan(1e-9);
    }

    private static void assertIsGrey(LinearRgb found, double level) {
        assertThat(found.red()).isCloseTo(level, EXACT);
        assertThat(found.green()).isCloseTo(level, EXACT);
        assertThat(found.blue()).isCloseTo(level, EXACT);
    }

    /**
     * A ball of radius 1 about the origin, seen from (0, 0, 5) along −z: the ray meets it after t = 4 at P = (0, 0, 1), where N = (0, 0, 1).
     * C = 0.5, A = 0.1, so the ambient term is 0.05.
     *
     * <p>Lamp 1 at (0, 3, 5): Q − P = (0, 3, 4), 5 long, L = (0, 0.6, 0.8), N·L = 0.8, diffuse kD·N·L = 0.5·0.8 = 0.4;
     * R = (0, 0, 1), R·L = 0.8, highlight kS·(R·L)² = 0.25·0.64 = 0.16; with I = 1: 0.4·0.5 + 0.16 = 0.36.
     *
     * <p>Lamp 2 at (3, 0, 5): as bright, but a ball of radius 0.5 stands half way, at (1.5, 0, 3), 2.5 from P: blocked after 2.
     *
     * <p>Lamp 3 at (0, 0, −9): N·L = −1, turned away. Altogether 0.05 + 0.36 = 0.41.
     */
    @Test
    void aBallInTheLightOfOneLampOfThree() {
        TracedRay ray = onlyPixel(scene(new Vec3(0, 0, 5), new Vec3(0, 0, -1), 5)
                .withAmbient(grey(0.1))
                .plus(Light.at(0, 3, 5)).plus(Light.at(3, 0, 5)).plus(Light.at(0, 0, -9))
                .plus(SceneObject.of(new Sphere(1)).named("ball").madeOf(Material.color(grey(0.5)).withDiffusion(0.5).withHighlight(0.25, 2)))
                .plus(SceneObject.of(new Sphere(0.5)).named("screen").at(1.5, 0, 3)));
        Encounter met = ray.encounter().orElseThrow();
        assertThat(label(met.place().surface())).isEqualTo("sphere \"ball\"");
        assertThat(met.place().distance()).isCloseTo(4, EXACT);
        assertIsAt(met.place().point(), 0, 0, 1);
        assertIsAt(met.place().normal(), 0, 0, 1);
        assertIsGrey(met.ambient(), 0.05);

        ShadowRay lit = met.lights().get(0).ray();
        assertThat(lit.distance()).isCloseTo(5, EXACT);
        assertIsAt(lit.direction(), 0, 0.6, 0.8);
        assertThat(lit.facing()).isCloseTo(0.8, EXACT);
        assertThat(lit.alignment()).isCloseTo(0.8, EXACT);
        assertThat(lit.visibility()).isEqualTo(1);
        assertThat(lit.diffuse()).isCloseTo(0.4, EXACT);
        assertThat(lit.highlight()).isCloseTo(0.16, EXACT);
        assertIsGrey(lit.added(), 0.36);

        ShadowRay blocked = met.lights().get(1).ray();
        assertThat(blocked.facing()).isCloseTo(0.8, EXACT);
        assertThat(blocked.visibility()).isZero();
        assertThat(blocked.obstacles()).singleElement().satisfies(obstacle -> {
            assertThat(label(new InScene<>(obstacle.surface().scene(), (BodyAt) obstacle.surface().part()))).isEqualTo("sphere \"screen\"");
            assertThat(obstacle.distance()).isCloseTo(2, EXACT);
        });

        ShadowRay behind = met.lights().get(2).ray();
        assertThat(behind.facing()).isCloseTo(-1, EXACT);
        assertThat(behind.isSent()).isFalse();
        assertIsGrey(ray.light(), 0.41);
    }

    /**
     * A slab of glass, black, index 4/3, kT = 0.5, from y = 0 down to y = −1, seen from (−4, 3, 0) along (0.8, −0.6, 0): after t = 5 at the
     * origin. cos θ₁ = 0.6, sin θ₁ = 0.8, sin θ₂ = 0.8·3/4 = 0.6: the ray goes on along (0.6, −0.8, 0), leaves after 1/0.8 = 1.25 at
     * (0.75, −1, 0), bent back to (0.8, −0.6, 0), and after 3/0.6 = 5 reaches the floor y = −4 at (4.75, −4, 0).
     *
     * <p>There C = 0.5, A = 0.2: ambient 0.1. A lamp 2 above, below the slab: N·L = 1, 0.8·0.5 = 0.4. Together 0.5, of which 0.5² arrives.
     */
    @Test
    void aFloorThroughASlabOfGlass() {
        Material glass = Material.color(Rgb.BLACK).withDiffusion(0).withTransparency(0.5, 4.0 / 3);
        TracedRay first = onlyPixel(scene(new Vec3(-4, 3, 0), new Vec3(0.8, -0.6, 0), 5)
                .withAmbient(grey(0.2))
                .plus(Light.at(4.75, -2, 0))
                .plus(SceneObject.of(new Block(new Vec3(-10, -1, -10), new Vec3(10, 0, 10))).named("slab").madeOf(glass))
                .plus(SceneObject.of(new Plane()).named("floor").at(0, -4, 0).madeOf(Material.color(grey(0.5)))));
        Encounter entering = first.encounter().orElseThrow();
        assertThat(entering.place().face()).isEqualTo(Shape.Face.PLUS_Y);
        assertThat(entering.place().distance()).isCloseTo(5, EXACT);
        Refraction in = entering.refraction().orElseThrow();
        assertThat(in.from()).isEqualTo(1);
        assertThat(in.to()).isEqualTo(4.0 / 3);
        assertThat(Math.sin(Math.toRadians(in.angleBeforeDegrees()))).isCloseTo(0.8, EXACT);
        assertThat(Math.sin(Math.toRadians(in.angleBeyondDegrees()))).isCloseTo(0.6, EXACT);

        TracedRay second = entering.refracted().orElseThrow();
        assertIsAt(second.direction(), 0.6, -0.8, 0);
        assertThat(second.medium().refractiveIndex()).isEqualTo(4.0 / 3);
        Encounter leaving = second.encounter().orElseThrow();
        assertThat(leaving.place().face()).isEqualTo(Shape.Face.MINUS_Y);
        assertThat(leaving.place().fromInside()).isTrue();
        assertThat(leaving.place().distance()).isCloseTo(1.25, EXACT);
        assertIsAt(leaving.place().point(), 0.75, -1, 0);
        assertThat(leaving.refraction().orElseThrow().criticalAngleDegrees()).isCloseTo(Math.toDegrees(Math.asin(0.75)), EXACT);

        TracedRay third = leaving.refracted().orElseThrow();
        assertIsAt(third.direction(), 0.8, -0.6, 0);
        assertThat(third.medium().solid()).isEmpty();
        Encounter floor = third.encounter().orElseThrow();
        assertIsAt(floor.place().point(), 4.75, -4, 0);
        assertThat(floor.place().distance()).isCloseTo(5, EXACT);
        assertIsGrey(floor.lights().get(0).added(), 0.4);
        assertIsGrey(third.light(), 0.5);
        assertIsGrey(second.light(), 0.25);
        assertIsGrey(first.light(), 0.125);
    }

    /**
     * The eye in a block of index 2, at (0, −3, 0), looks along (0.8, 0.6, 0) at its upper face y = 0: after t = 5 at (4, 0, 0).
     * cos θ₁ = 0.6, sin θ₂ would be 2·0.8 = 1.6: all light is mirrored, weight kR + kT = 0.25 + 0.5, along (0.8, −0.6, 0). The bottom
     * y = −6 is met after 6/0.6 = 10, and there level 2 is the last. Both points have the ambient term 0.2·0.5 only:
     * 0.1 + 0.75·0.1 = 0.175.
     */
    @Test
    void totalReflectionInsideABlock() {
        Material glass = Material.color(grey(0.5)).withDiffusion(0).withReflection(0.25).withTransparency(0.5, 2);
        TracedRay first = onlyPixel(scene(new Vec3(0, -3, 0), new Vec3(0.8, 0.6, 0), 2)
                .withAmbient(grey(0.2))
                .plus(SceneObject.of(new Block(new Vec3(-50, -6, -50), new Vec3(50, 0, 50))).named("block").madeOf(glass)));
        assertThat(label(first.medium().solid().orElseThrow())).isEqualTo("block \"block\"");
        Encounter top = first.encounter().orElseThrow();
        assertIsAt(top.place().point(), 4, 0, 0);
        assertIsAt(top.place().normal(), 0, 1, 0);
        assertIsAt(top.place().towardsViewer(), 0, -1, 0);
        Refraction bend = top.refraction().orElseThrow();
        assertThat(bend.isTotal()).isTrue();
        assertThat(bend.criticalAngleDegrees()).isCloseTo(30, EXACT);
        assertThat(top.refracted()).isEmpty();

        TracedRay second = top.reflected().orElseThrow();
        assertThat(second.weight()).isEqualTo(LinearRgb.WHITE.times(0.75));
        assertIsAt(second.direction(), 0.8, -0.6, 0);
        Encounter bottom = second.encounter().orElseThrow();
        assertThat(bottom.place().distance()).isCloseTo(10, EXACT);
        assertThat(bottom.cutOff()).isTrue();
        assertIsGrey(second.light(), 0.1);
        assertIsGrey(first.light(), 0.175);
    }

    private static String label(InScene<BodyAt> body) {
        return body.part().label(body.scene());
    }
}
