package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.LightTerm;
import cz.paprsek.render.explain.LightTerm.ShadowRay;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.CustomLight;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Lights against closed forms. A white floor of diffusion 1 is E/π bright, which is I·cos θ in the unit of intensities. */
class LightsTest {
    private static final Offset<Double> EXACT = within(1e-12);
    private static final int MANY = 4096;
    private static final SceneObject FLOOR = SceneObject.of(new Rectangle(-100, -100, 100, 100)).rotated(-90, 0, 0).madeOf(Material.DEFAULT.withDiffusion(1));

    /** What a ray sees of a point of the floor, coming from above. */
    private static TracedRay seen(Light light, double x, double z) {
        return RenderScene.of(Scene.EMPTY.withLights(List.of(light)).plus(FLOOR)).explainRay(new Vec3(x, 0.01, z), new Vec3(0, -1, 0), 1);
    }

    private static double bright(Light light, double x, double z) {
        return seen(light, x, z).light().red();
    }

    private static double relative(double found, double expected) {
        return Math.abs(found / expected - 1);
    }

    /** E = (L/2)·|Σ θᵢ n·(dᵢ×dᵢ₊₁)/|dᵢ×dᵢ₊₁||, with d to the corners in order: Lambert's formula. */
    private static double polygon(double radiance, Vec3 point, Vec3 normal, List<Vec3> corners) {
        double sum = 0;
        for (int i = 0; i < corners.size(); i++) {
            Vec3 a = corners.get(i).minus(point).normalized();
            Vec3 b = corners.get((i + 1) % corners.size()).minus(point).normalized();
            sum += Math.acos(a.dot(b)) * normal.dot(a.cross(b).normalized());
        }
        return radiance / 2 * Math.abs(sum);
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "1, 0.5", "-2, 1", "0.3, -3"})
    void aRectangleIsAsBrightAsLambertsFormulaSays(double x, double z) {
        AreaLight light = AreaLight.rectangle(new Vec3(0, 2, 0), 1.5, 1).withRotation(new Vec3(90, 0, 0)).withIntensity(0.7).withReferenceDistance(2).withSamples(MANY);
        List<Vec3> corners = List.of(new Vec3(-0.75, 2, -0.5), new Vec3(0.75, 2, -0.5), new Vec3(0.75, 2, 0.5), new Vec3(-0.75, 2, 0.5));
        double radiance = Math.PI * 0.7 * 4 / 1.5;
        double expected = polygon(radiance, new Vec3(x, 0, z), Vec3.Y, corners) / Math.PI;
        assertThat(relative(bright(light, x, z), expected)).isLessThan(0.005);
    }

    @ParameterizedTest
    @CsvSource({"0.3, 1", "1, 2", "2, 0.5"})
    void aDiscIsAsBrightOnItsAxisAsItShouldBe(double radius, double distance) {
        AreaLight light = AreaLight.disc(new Vec3(0, distance, 0), radius).withRotation(new Vec3(90, 0, 0)).withSamples(MANY);
        double radiance = Math.PI / (Math.PI * radius * radius);
        double expected = radiance * radius * radius / (radius * radius + distance * distance);
        assertThat(relative(bright(light, 0, 0), expected)).isLessThan(0.005);
    }

    /** E = πL(r/d)²·cos θ wherever all of it is above the horizon. */
    @ParameterizedTest
    @CsvSource({"0, 0, 0.5", "1, 1, 0.5", "3, 0, 1.9", "0, 0, 1.99"})
    void aBallIsAsBrightAsItShouldBe(double x, double z, double radius) {
        SphereLight light = SphereLight.of(new Vec3(0, 2, 0), radius).withReferenceDistance(3).withSamples(MANY);
        double d = Math.sqrt(x * x + 4 + z * z);
        assertThat(relative(bright(light, x, z), 9 / (d * d) * (2 / d))).isLessThan(0.005);
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "0.5, 1", "20, 1", "60, 1", "20, 0.6"})
    void aSunWithADiscBringsWhatASharpOneDoes(double angle, double cosine) {
        double sine = Math.sqrt(1 - cosine * cosine);
        SunLight light = SunLight.along(sine, -cosine, 0).withDisc(angle, false).withIntensity(0.8);
        // Sixteen samples, well strewn.
        assertThat(relative(bright(light, 0, 0), 0.8 * cosine)).isLessThan(angle == 0 ? 1e-12 : 0.01);
    }

    static Stream<Light> fromAfar() {
        Vec3 place = new Vec3(0, 100, 0);
        return Stream.of(AreaLight.rectangle(place, 1, 2).withRotation(new Vec3(90, 0, 0)).withReferenceDistance(50),
                AreaLight.disc(place, 1).withRotation(new Vec3(90, 0, 0)).withReferenceDistance(50), SphereLight.of(place, 1).withReferenceDistance(50),
                new SpotLight("", place, new Camera.Direction(new Vec3(0, -1, 0)), Rgb.WHITE, 1, 50, 30, 45));
    }

    @ParameterizedTest
    @MethodSource("fromAfar")
    void fromAfarEveryLightIsAsAPoint(Light light) {
        double point = bright(Light.at(0, 100, 0).withReferenceDistance(50), 1, 1);
        assertThat(relative(bright(light, 1, 1), point)).isLessThan(0.001);
    }

    @Test
    void aPointFallsWithTheSquareOfTheDistance() {
        assertThat(bright(Light.at(0, 4, 0).withReferenceDistance(2), 0, 0)).isCloseTo(0.25, EXACT);
        assertThat(bright(Light.at(0, 4, 0), 0, 0)).isCloseTo(1, EXACT);
    }

    @Test
    void aConeFallsBetweenItsAnglesAsACubic() {
        SpotLight light = SpotLight.from(new Vec3(0, 1, 0), Vec3.ZERO);
        double inner = Math.cos(Math.toRadians(30));
        double outer = Math.cos(Math.toRadians(45));
        for (double degrees = 1; degrees < 60; degrees += 2.5) {
            double cosine = Math.cos(Math.toRadians(degrees));
            double t = Math.min(1, Math.max(0, (cosine - outer) / (inner - outer)));
            assertThat(bright(light, Math.tan(Math.toRadians(degrees)), 0)).as("at %s", degrees).isCloseTo(cosine * t * t * (3 - 2 * t), EXACT);
        }
        assertThat(bright(light.withAngles(30, 30), 0.57, 0)).isPositive();
        assertThat(bright(light.withAngles(30, 30), 0.58, 0)).isZero();
    }

    /** An inner angle left out is 30 degrees, or the outer angle if that is smaller, also in a file that is written and changed. */
    @Test
    void anInnerAngleThatIsNotGivenGivesWayToASmallerOuterOne() throws Exception {
        String text = "<scene xmlns=\"urn:paprsek:scene:1\"><camera position=\"0 1 5\" target=\"0 0 0\"/><spot-light position=\"0 1 0\" direction=\"0 -1 0\" outer-angle=\"20\"/></scene>";
        Scene scene = SceneFiles.parse(text);
        assertThat(bright(scene.lights().get(0), 0.36, 0)).isCloseTo(Math.cos(Math.atan(0.36)), EXACT);
        assertThat(bright(scene.lights().get(0), 0.37, 0)).isZero();
        assertThat(SceneFiles.format(scene)).contains("outer-angle=\"20\"").doesNotContain("inner-angle");
        assertThat(SceneFiles.parse(SceneFiles.format(scene))).isEqualTo(scene);
        Scene wide = SceneFiles.parse(text.replace("outer", "inner-angle=\"30\" outer").replace("20", "40"));
        SpotLight narrowed = ((SpotLight) wide.lights().get(0)).withAngles(30, 20);
        assertThat(SceneFiles.parse(SceneFiles.format(wide.withLights(List.of(narrowed))))).isEqualTo(scene);
    }

    @Test
    void aFlatLightShinesToOneSideOnly() {
        assertThat(bright(AreaLight.rectangle(new Vec3(0, 2, 0), 1, 1).withRotation(new Vec3(-90, 0, 0)), 0, 0)).isZero();
        assertThat(bright(SphereLight.of(new Vec3(0, 0.5, 0), 1), 0, 0)).as("within the ball").isZero();
    }

    @Test
    void aVisibleLightIsSeenAsBrightAsItIs() {
        AreaLight panel = AreaLight.rectangle(Vec3.ZERO, 2, 0.5).withIntensity(0.25).withReferenceDistance(3);
        assertThat(along(panel, new Vec3(0.5, 0, 4), new Vec3(0, 0, -1)).light().red()).isCloseTo(Math.PI * 0.25 * 9, EXACT);
        assertThat(along(panel, new Vec3(0.5, 0, -4), new Vec3(0, 0, 1)).light().red()).as("from behind").isZero();
        assertThat(along(panel, new Vec3(0.5, 0, -4), new Vec3(0, 0, 1)).seen().orElseThrow().distance()).isCloseTo(4, EXACT);
        assertThat(along(panel.withVisible(false), new Vec3(0.5, 0, 4), new Vec3(0, 0, -1)).light().red()).isCloseTo(0.5, within(1e-9));
        SphereLight ball = SphereLight.of(Vec3.ZERO, 0.5);
        assertThat(along(ball, new Vec3(0, 0, 4), new Vec3(0, 0, -1)).light().red()).isCloseTo(4, EXACT);
        assertThat(along(ball, Vec3.ZERO, new Vec3(0, 0, -1)).light().red()).as("from inside").isZero();
        SunLight sun = SunLight.along(0, 0, 1).withDisc(10, true);
        double sine = Math.sin(Math.toRadians(5));
        assertThat(along(sun, Vec3.ZERO, new Vec3(0, Math.tan(Math.toRadians(4.9)), -1)).light().red()).isCloseTo(1 / (sine * sine), within(1e-9));
        assertThat(along(sun, Vec3.ZERO, new Vec3(0, Math.tan(Math.toRadians(5.1)), -1)).light().red()).isCloseTo(0.5, within(1e-9));
    }

    private static TracedRay along(Light light, Vec3 origin, Vec3 direction) {
        return RenderScene.of(Scene.EMPTY.withBackground(Rgb.ofLinear(0.5, 0.5, 0.5)).withLights(List.of(light))).explainRay(origin, direction, 2);
    }

    @Test
    void whatIsSeenOfALightShadowsOthersButNotItself() {
        AreaLight panel = AreaLight.rectangle(new Vec3(0, 2, 0), 1, 1).withRotation(new Vec3(90, 0, 0));
        assertThat(seen(panel, 0.3, 0.1).light()).isEqualTo(seen(panel.withVisible(false), 0.3, 0.1).light());
        SphereLight ball = SphereLight.of(new Vec3(0, 2, 0), 0.7);
        assertThat(seen(ball, 2, 0.1).light()).isEqualTo(seen(ball.withVisible(false), 2, 0.1).light());
        Scene both = Scene.EMPTY.withLights(List.of(Light.at(0, 5, 0).named("lamp"), panel.named("panel"))).plus(FLOOR);
        LightTerm lamp = RenderScene.of(both).explainRay(new Vec3(0, 0.01, 0), new Vec3(0, -1, 0), 1).encounter().orElseThrow().lights().get(0);
        assertThat(lamp.visibility()).isZero();
        assertThat(lamp.ray().obstacles()).singleElement().satisfies(obstacle -> assertThat(obstacle.distance()).isCloseTo(2, within(1e-9)));
    }

    @Test
    void aLightFlushWithTheCeilingIsSeenAndShines() {
        SceneObject ceiling = SceneObject.of(new Rectangle(-5, -5, 5, 5)).rotated(90, 0, 0).at(0, 2, 0);
        AreaLight panel = AreaLight.rectangle(new Vec3(0, 2, 0), 1, 1).withRotation(new Vec3(90, 0, 0));
        RenderScene scene = RenderScene.of(Scene.EMPTY.withLights(List.of(panel)).plus(FLOOR, ceiling));
        assertThat(scene.explainRay(new Vec3(0.2, 1, 0.1), Vec3.Y, 1).seen()).isPresent();
        LightTerm term = scene.explainRay(new Vec3(0.2, 1, 0.1), new Vec3(0, -1, 0), 1).encounter().orElseThrow().lights().get(0);
        assertThat(term.visibility()).isEqualTo(1);
    }

    private static Scene soft() {
        return Scene.EMPTY.withSettings(new RenderSettings(72, 50, 4, 1)).withCamera(Camera.lookingAt(new Vec3(0, 3, 8), new Vec3(0, 0.8, 0)).withFovy(40))
                .withLights(List.of(AreaLight.rectangle(new Vec3(-2, 3.5, 1), 1, 1).withRotation(new Vec3(80, 0, -30)).withReferenceDistance(3).withSamples(7).named("panel"),
                        SphereLight.of(new Vec3(2, 2, 1), 0.3).withSamples(4).withReferenceDistance(2), SunLight.along(-1, -1, -0.3).withDisc(5, true).withIntensity(0.3),
                        AreaLight.disc(new Vec3(0, 4, -2), 0.5).withRotation(new Vec3(60, 0, 0)).withReferenceDistance(2), SpotLight.from(new Vec3(3, 4, 2), Vec3.ZERO)))
                .plus(FLOOR, SceneObject.of(new Sphere(0.8)).at(-1, 0.8, 0).madeOf(Material.color(200, 80, 70).withReflection(0.2).withHighlight(0.5, 40)),
                        SceneObject.of(new Sphere(0.6)).at(1, 0.6, 1).madeOf(Material.DEFAULT.withDiffusion(0.1).withTransparency(0.8, 1.5)));
    }

    @Test
    void softShadowsAreTheSameForAnyThreadsAndRegions() {
        Scene scene = soft().withSettings(soft().settings().withSamples(2));
        RenderScene prepared = RenderScene.of(scene);
        Image whole = Renderer.render(prepared, RenderOptions.of(scene).withThreads(1), RenderMonitor.NONE).image();
        assertThat(Renderer.render(prepared, RenderOptions.of(scene).withThreads(4), RenderMonitor.NONE).image().toArgb()).isEqualTo(whole.toArgb());
        Tile part = new Tile(23, 17, 31, 20);
        Image region = Renderer.render(prepared, RenderOptions.of(scene).withRegion(part), RenderMonitor.NONE).image();
        for (int y = 0; y < part.height(); y++) {
            for (int x = 0; x < part.width(); x++) {
                assertThat(region.red(x, y)).isEqualTo(whole.red(part.x() + x, part.y() + y));
                assertThat(region.blue(x, y)).isEqualTo(whole.blue(part.x() + x, part.y() + y));
            }
        }
    }

    @Test
    void aSoftShadowIsExplainedRayByRayAndAddsUpBitForBit() {
        Scene scene = soft();
        Image image = Renderer.render(scene);
        RenderScene prepared = RenderScene.of(scene);
        for (int row = 0; row < image.height(); row += 3) {
            for (int column = 0; column < image.width(); column++) {
                Pixel pixel = prepared.explain(column, row);
                LinearRgb light = pixel.light();
                assertThat(new float[] {(float) light.red(), (float) light.green(), (float) light.blue()}).as("pixel %d,%d", column, row)
                        .isEqualTo(new float[] {image.red(column, row), image.green(column, row), image.blue(column, row)});
                pixel.rays().forEach(ray -> ray.encounter().ifPresent(LightsTest::assertAddsUp));
            }
        }
        assertThat(prepared.explain(36, 40).rays().get(0).encounter().orElseThrow().lights()).extracting(term -> term.rays().size()).containsExactly(7, 4, 16, 16, 1);
    }

    private static void assertAddsUp(Encounter met) {
        for (LightTerm term : met.lights()) {
            LinearRgb sum = term.rays().stream().map(ShadowRay::added).reduce(LinearRgb.BLACK, LinearRgb::plus);
            assertThat(term.rays().size() == 1 ? sum : sum.times(1.0 / term.rays().size())).isEqualTo(term.added());
        }
    }

    /** A point made in code, as no kind of file has it: green and twice as bright as it is said to be. */
    private record Glowworm(Vec3 position, double intensity) implements CustomLight {
        @Override
        public Light withIntensity(double value) {
            return new Glowworm(position, value);
        }

        @Override
        public boolean sample(Hit from, double u, double v, Arrival out) {
            out.towards(from, position.x(), position.y(), position.z());
            out.light(0, 2 * intensity, 0);
            return intensity > 0;
        }
    }

    @Test
    void whatEachLightAddsAddsUpToThePicture() {
        Scene scene = soft().plus(new Glowworm(new Vec3(1, 3, 3), 0.2)).plus(Light.at(-3, 4, 4).withIntensity(0.2))
                .withAmbient(Rgb.grey(60)).withBackground(new Rgb(30, 60, 120));
        scene = scene.withSettings(scene.settings().withSamples(2));
        Image whole = Renderer.render(scene);
        List<Image> parts = new ArrayList<>();
        parts.add(Renderer.render(scene.withLights(scene.lights().stream().map(light -> light.withIntensity(0)).toList())));
        for (int i = 0; i < scene.lights().size(); i++) {
            parts.add(Renderer.render(scene.litBy(i)));
        }
        for (int y = 0; y < whole.height(); y++) {
            for (int x = 0; x < whole.width(); x++) {
                double[] sum = new double[3];
                for (Image part : parts) {
                    sum[0] += part.red(x, y);
                    sum[1] += part.green(x, y);
                    sum[2] += part.blue(x, y);
                }
                double[] expected = Scenes.pixel(whole, x, y);
                for (int k = 0; k < 3; k++) {
                    assertThat(sum[k]).as("pixel %d,%d", x, y).isCloseTo(expected[k], within(2e-6 * Math.max(1, expected[k])));
                }
            }
        }
    }
}
