package cz.paprsek.render.integrate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.asset.Assets;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.mesh.Meshes;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Paths against closed forms; units as those of lights: a floor of diffusion 1 is E/π bright. */
class PathsTest {
    private static final Material GREY = Material.DEFAULT.withDiffusion(0.6);

    private static World world(Scene scene) {
        return new World(scene, new Textures(Assets.none()), () -> false);
    }

    /** The mean of what paths bring along one ray, red. */
    private static double bright(Scene scene, int depth, int paths, Vec3 origin, Vec3 direction) {
        Paths tracer = new Paths(world(scene), depth, new Passes(RenderSettings.DEFAULT.withIntegrator(Integrator.PATH).withSamples(paths), false));
        tracer.begin(() -> false);
        double sum = 0;
        for (int i = 0; i < paths; i++) {
            tracer.startAlone(origin, direction.normalized());
            tracer.sampler.start(3, 5, i);
            tracer.traceAlone();
            sum += tracer.alone().red;
        }
        return sum / paths;
    }

    private static Scene inside(Material material) {
        return Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).madeOf(material));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 5, 7})
    void withinAGlowingBallEachBounceAddsItsShare(int depth) {
        Scene furnace = inside(GREY.withEmission(Rgb.WHITE, 0.5));
        double expected = 0;
        for (int i = 0; i <= depth; i++) {
            expected += 0.5 * Math.pow(0.6, i);
        }
        assertThat(bright(furnace, depth, 3, new Vec3(0.2, 0.1, -0.3), new Vec3(1, 2, 3))).isCloseTo(expected, within(1e-12));
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 0", "0.5, 0.2, 0.1", "0, -0.6, 0"})
    void anIntegratingSphereIsAsBrightAsItsAlbedoSays(double x, double y, double z) {
        Vec3 lamp = new Vec3(x, y, z);
        Scene sphere = inside(GREY).withLights(List.of(new PointLight("lamp", lamp, Rgb.WHITE, 0.5, 1)));
        Vec3 point = new Vec3(0, 0, 1);
        Vec3 towards = lamp.minus(point);
        double cosine = -towards.normalized().z();
        // In units of π: E of the lamp, and its Φ/4πR².
        double direct = 0.5 * cosine / towards.dot(towards);
        double expected = 0.6 * (direct + 0.6 / 0.4 * 0.5);
        assertThat(bright(sphere, 60, 1 << 17, Vec3.ZERO, point) / expected).isCloseTo(1, within(0.002));
    }

    /** Directions of the surface find the lamp as well as points of it do: both together are what either is. */
    @ParameterizedTest
    @CsvSource({"true, 0, 0", "false, 0, 0", "true, 1, 0.5", "false, 1, 0.5", "true, -2, 1"})
    void aRectangleIsAsBrightAsLambertsFormulaSays(boolean isVisible, double x, double z) {
        AreaLight light = AreaLight.rectangle(new Vec3(0, 2, 0), 1.5, 1).withRotation(new Vec3(90, 0, 0)).withIntensity(0.7).withReferenceDistance(2).withVisible(isVisible);
        List<Vec3> corners = List.of(new Vec3(-0.75, 2, -0.5), new Vec3(0.75, 2, -0.5), new Vec3(0.75, 2, 0.5), new Vec3(-0.75, 2, 0.5));
        double expected = polygon(Math.PI * 0.7 * 4 / 1.5, new Vec3(x, 0, z), corners) / Math.PI;
        assertThat(bright(floor(light), 1, 1 << 14, new Vec3(x, 1, z), new Vec3(0, -1, 0)) / expected).isCloseTo(1, within(0.002));
    }

    @ParameterizedTest
    @CsvSource({"true", "false"})
    void aBallIsAsBrightAsItsSolidAngleSays(boolean isVisible) {
        SphereLight light = SphereLight.of(new Vec3(1, 2, 0), 0.7).withIntensity(0.4).withVisible(isVisible);
        double square = 5;
        // πL(r/d)²cos θ, L = I·D²/r², by π.
        double expected = 0.4 / square * (2 / Math.sqrt(square));
        assertThat(bright(floor(light), 1, 1 << 14, new Vec3(0, 1, 0), new Vec3(0, -1, 0)) / expected).isCloseTo(1, within(0.002));
    }

    /** No point of a lamp is looked for from behind it: what a path sees there counts in full, however it came. */
    @Test
    void theDarkSideOfALampIsBlack() {
        Paths tracer = new Paths(world(floor(AreaLight.rectangle(new Vec3(0, 2, 0), 1.5, 1).withRotation(new Vec3(-90, 0, 0)))), 1,
                new Passes(RenderSettings.DEFAULT.withIntegrator(Integrator.PATH).withSamples(1), false));
        tracer.startAlone(Vec3.ZERO, new Vec3(0, 1, 0));
        tracer.findAlone();
        tracer.alone().density = 0;
        assertThat(tracer.unlit(tracer.alone(), 0)).isEqualTo(1);
    }

    /** Nothing but directions of the surface finds a body that glows. */
    @Test
    void aRectangleThatGlowsIsAsBrightAsALampOfItsRadiance() {
        SceneObject body = SceneObject.of(new Rectangle(-0.75, -0.5, 0.75, 0.5)).rotated(90, 0, 0).at(0, 2, 0)
                .madeOf(Material.DEFAULT.withDiffusion(0).withHighlight(0, 1).withEmission(Rgb.WHITE, 3));
        List<Vec3> corners = List.of(new Vec3(-0.75, 2, -0.5), new Vec3(0.75, 2, -0.5), new Vec3(0.75, 2, 0.5), new Vec3(-0.75, 2, 0.5));
        double expected = polygon(3, Vec3.ZERO, corners) / Math.PI;
        assertThat(bright(floor().plus(body), 1, 1 << 16, new Vec3(0, 1, 0), new Vec3(0, -1, 0)) / expected).isCloseTo(1, within(0.005));
    }

    /** Under an even sky a convex body of albedo 1 cannot be told from the sky, whatever its lobes. */
    @Test
    void underAnEvenSkyABodyThatTakesNothingIsNotSeen() {
        Scene sky = Scene.EMPTY.withBackground(Rgb.WHITE);
        Material diffuse = GREY.withDiffusion(1);
        Material glass = GREY.withDiffusion(0).withReflection(1).withTransparency(1, 1.5).withFresnel(Fresnel.TRUE);
        for (Material material : List.of(diffuse, glass)) {
            assertThat(bright(sky.plus(SceneObject.of(new Sphere(1)).madeOf(material)), 200, 4096, new Vec3(0, 0.5, 5), new Vec3(0, 0, -1)))
                    .as(material.toString()).isCloseTo(1, within(1e-3));
        }
    }

    /** A lamp seen in a rough mirror, by directions of the surface alone (it glows), and by both. */
    @ParameterizedTest
    @ValueSource(doubles = {0.2, 0.4, 0.7})
    void aRoughMirrorShowsALampAsBrightAsABodyThatGlowsLikeIt(double roughness) {
        Material mirror = GREY.withDiffusion(0.2).withReflection(0.7).withRoughness(roughness);
        AreaLight lamp = AreaLight.rectangle(new Vec3(0, 2, 0), 1.5, 1).withRotation(new Vec3(90, 0, 0)).withIntensity(3 * 1.5 / Math.PI).withVisible(true);
        SceneObject body = SceneObject.of(new Rectangle(-0.75, -0.5, 0.75, 0.5)).rotated(90, 0, 0).at(0, 2, 0)
                .madeOf(Material.DEFAULT.withDiffusion(0).withHighlight(0, 1).withEmission(Rgb.WHITE, 3));
        SceneObject floor = SceneObject.of(new Rectangle(-100, -100, 100, 100)).rotated(-90, 0, 0).madeOf(mirror);
        Vec3 from = new Vec3(0.8, 1, 0);
        double both = bright(Scene.EMPTY.withLights(List.of(lamp)).plus(floor), 1, 1 << 15, from, new Vec3(-0.4, -1, 0));
        double alone = bright(Scene.EMPTY.plus(floor).plus(body), 1, 1 << 17, from, new Vec3(-0.4, -1, 0));
        assertThat(both / alone).isCloseTo(1, within(0.01));
    }

    /** The Phong highlight as a lobe: by points of the lamp alone, which is not seen, and by both. */
    @Test
    void aHighlightIsAsBrightByBothWays() {
        Material shiny = GREY.withDiffusion(0.3).withHighlight(0.5, 30);
        SceneObject floor = SceneObject.of(new Rectangle(-100, -100, 100, 100)).rotated(-90, 0, 0).madeOf(shiny);
        AreaLight lamp = AreaLight.rectangle(new Vec3(0, 2, 0), 1.5, 1).withRotation(new Vec3(90, 0, 0)).withIntensity(1);
        double points = bright(Scene.EMPTY.withLights(List.of(lamp.withVisible(false))).plus(floor), 1, 1 << 15, new Vec3(1, 1, 0), new Vec3(-0.8, -1, 0));
        double both = bright(Scene.EMPTY.withLights(List.of(lamp.withVisible(true))).plus(floor), 1, 1 << 15, new Vec3(1, 1, 0), new Vec3(-0.8, -1, 0));
        assertThat(both / points).isCloseTo(1, within(0.003));
    }

    /** Where flat pieces stand for a round body they are lit from beyond their edge, where no path can go: what points of a lamp bring there counts in full. */
    @Test
    void aRoundedBodyIsAsBrightByBothWaysWhereLightGrazesIt() {
        SceneObject ball = SceneObject.of(Mesh.of(Meshes.ball(1, 10).smoothed(60))).madeOf(GREY.withHighlight(0, 1));
        AreaLight lamp = AreaLight.rectangle(new Vec3(2, 0, 0), 1.5, 1.5).withRotation(new Vec3(0, -90, 0)).withIntensity(1);
        double points = 0;
        double both = 0;
        for (int i = 0; i < 12; i++) {
            Vec3 towards = new Vec3(0.1 + 0.05 * i, 0.13, 0).minus(new Vec3(0, 0, 5));
            points += bright(Scene.EMPTY.withLights(List.of(lamp.withVisible(false))).plus(ball), 1, 2048, new Vec3(0, 0, 5), towards);
            both += bright(Scene.EMPTY.withLights(List.of(lamp)).plus(ball), 1, 2048, new Vec3(0, 0, 5), towards);
        }
        assertThat(both / points).isCloseTo(1, within(0.003));
    }

    /** Light that no path can hit, black around, nothing that glows: then the first hit is what it is without paths. */
    @ParameterizedTest
    @ValueSource(strings = {"primitives", "csg", "glass"})
    void atDepthOneItIsThePictureWithoutPaths(String name) throws IOException, SceneFileException {
        Scene scene = SceneFiles.read(Path.of("../scenes", name + ".xml")).withBackground(Rgb.BLACK);
        World world = world(scene);
        Paths paths = new Paths(world, 1, new Passes(RenderSettings.DEFAULT.withIntegrator(Integrator.PATH).withSamples(1), false));
        Whitted whitted = new Whitted(world, 1, Sampling.grid(1));
        paths.begin(() -> false);
        whitted.begin(() -> false);
        Eye eye = Eye.of(scene.camera(), 64, 48, 1);
        int lit = 0;
        for (int y = 0; y < 48; y++) {
            for (int x = 0; x < 64; x++) {
                Level there = light(paths, eye, x, y);
                Level here = light(whitted, eye, x, y);
                assertThat(new double[] {there.red, there.green, there.blue}).as("%d %d", x, y).containsExactly(here.red, here.green, here.blue);
                lit += here.red > 0 ? 1 : 0;
            }
        }
        assertThat(lit).isGreaterThan(100);
    }

    private static Level light(BlockTracer tracer, Eye eye, int x, int y) {
        tracer.startAlone(eye, x + 0.5, y + 0.5);
        tracer.traceAlone();
        return tracer.alone();
    }

    private static Scene floor(cz.paprsek.scene.Light... lights) {
        return Scene.EMPTY.withLights(List.of(lights))
                .plus(SceneObject.of(new Rectangle(-100, -100, 100, 100)).rotated(-90, 0, 0).madeOf(GREY.withDiffusion(1)));
    }

    /** E = (L/2)·|Σ θᵢ n·(dᵢ×dᵢ₊₁)/|dᵢ×dᵢ₊₁||, with d to the corners in order: Lambert's formula. */
    private static double polygon(double radiance, Vec3 point, List<Vec3> corners) {
        double sum = 0;
        for (int i = 0; i < corners.size(); i++) {
            Vec3 a = corners.get(i).minus(point).normalized();
            Vec3 b = corners.get((i + 1) % corners.size()).minus(point).normalized();
            sum += Math.acos(a.dot(b)) * Vec3.Y.dot(a.cross(b).normalized());
        }
        return radiance / 2 * Math.abs(sum);
    }
}
