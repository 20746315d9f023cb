package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.Layers;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What is known of the pixels of paths beside their light. */
class PathLayersTest {
    private static final List<Layer> ALL = List.of(Layer.values());
    private static final RenderSettings SETTINGS = new RenderSettings(24, 20, 4, 1).withIntegrator(Integrator.PATH).withSamples(80);
    /** Matt, mirroring, glass that absorbs, a body that glows, a light that is seen and one that is not. */
    static final Scene SCENE = Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 1.5, 5), new Vec3(0, 0.5, 0))).withBackground(new Rgb(30, 50, 80))
            .withLights(List.of(SphereLight.of(new Vec3(1, 3, 1), 0.5).withIntensity(2), new PointLight("left", new Vec3(-3, 2, 2), Rgb.WHITE, 0.6, 0)))
            .plus(SceneObject.of(new Rectangle(-4, -4, 4, 4)).rotated(-90, 0, 0).madeOf(Material.color(200, 120, 80)))
            .plus(SceneObject.of(new Sphere(0.6)).at(-1, 0.6, 0).madeOf(Material.color(250, 250, 250).withDiffusion(0.2).withReflection(0.7)))
            .plus(SceneObject.of(new Sphere(0.5)).at(0.4, 0.5, 1).madeOf(Material.color(255, 255, 255).withDiffusion(0).withTransparency(0.9, 1.5).withAttenuation(new Rgb(90, 255, 90), 0.5)))
            .plus(SceneObject.of(new Sphere(0.3)).at(1.6, 0.3, 0.4).madeOf(Material.DEFAULT.withDiffusion(0).withEmission(new Rgb(255, 120, 20), 3)));

    private static RenderResult render(Scene scene, RenderOptions options) {
        return Renderer.render(RenderScene.of(scene), options, RenderMonitor.NONE);
    }

    private static Map<String, Float> at(RenderResult result, int x, int y) {
        return result.layers().names().stream().collect(Collectors.toMap(name -> name, name -> result.layers().at(name, x, y)));
    }

    @ParameterizedTest
    @EnumSource(names = {"BOX", "MITCHELL"})
    void layersChangeNoBitOfThePictureAndLightsAreItsSum(PixelFilter filter) {
        RenderOptions options = RenderOptions.of(SETTINGS.withFilter(filter));
        RenderResult layered = render(SCENE, options.withLayers(ALL));
        Layers layers = layered.layers();
        assertThat(Scenes.difference(layered.image(), render(SCENE, options).image(), 0)).isZero();
        assertThat(layers.names()).contains("error.V", "light.1.R", "light.left.G", "light.rest.B", "samples.N");
        for (int i = 0; i < 24 * 20 && filter == PixelFilter.BOX; i++) {
            double light = layered.image().red(i % 24, i / 24);
            assertThat(LayersTest.sumOfLights(layers, i % 24, i / 24)).as("of all lights").isCloseTo(light, within(1e-6 * (1 + light)));
            assertThat(layers.at("direct.R", i % 24, i / 24) + (double) layers.at("indirect.R", i % 24, i / 24)).isCloseTo(light, within(1e-6 * (1 + light)));
            assertThat(layers.at("samples.N", i % 24, i / 24)).isEqualTo(80);
        }
    }

    /** A light's layer is the picture of it alone: the others dark, no background, nothing that glows. */
    @Test
    void eachLightsLayerIsThePictureThatItMakesAlone() {
        Layers layers = render(SCENE, RenderOptions.of(SETTINGS).withLayers(List.of(Layer.LIGHT))).layers();
        Scene dark = SCENE.withBackground(Rgb.BLACK).withObjects(SCENE.objects().subList(0, 3))
                .plus(SceneObject.of(new Sphere(0.3)).at(1.6, 0.3, 0.4).madeOf(Material.DEFAULT.withDiffusion(0)));
        for (int light = 0; light < 2; light++) {
            int lit = light;
            List<Light> others = List.of(SCENE.lights().get(0).withIntensity(lit == 0 ? 2 : 0), SCENE.lights().get(1).withIntensity(lit == 1 ? 0.6 : 0));
            RenderResult alone = render(dark.withLights(others), RenderOptions.of(SETTINGS));
            String name = lit == 0 ? "light.1.G" : "light.left.G";
            for (int i = 0; i < 24 * 20; i++) {
                assertThat((double) layers.at(name, i % 24, i / 24)).isCloseTo(alone.image().green(i % 24, i / 24), within(1e-5));
            }
        }
    }

    /** First hits are the same whatever becomes of light, and mean the same. */
    @Test
    void whatIsSeenFirstIsAsWithWhitted() {
        List<Layer> first = List.of(Layer.NORMAL, Layer.ALBEDO, Layer.DEPTH, Layer.OBJECT);
        RenderSettings paths = SETTINGS.withSamples(256);
        RenderSettings rays = paths.withIntegrator(Integrator.WHITTED).withSamples(16);
        Layers ofPaths = render(SCENE, RenderOptions.of(paths).withLayers(first)).layers();
        Layers ofRays = render(SCENE, RenderOptions.of(rays).withLayers(first)).layers();
        assertThat(ofPaths.names()).isEqualTo(ofRays.names());
        int inside = 0;
        for (int i = 0; i < 24 * 20; i++) {
            int x = i % 24;
            int y = i / 24;
            boolean isEdge = x == 0 || y == 0 || x == 23 || y == 19;
            for (int k = 0; k < 9 && !isEdge; k++) {
                isEdge = ofRays.at("object.ID", x + k % 3 - 1, y + k / 3 - 1) != ofRays.at("object.ID", x, y);
            }
            if (!isEdge) {
                inside++;
                assertThat(ofPaths.at("object.ID", x, y)).isEqualTo(ofRays.at("object.ID", x, y));
                assertThat(ofPaths.at("depth.Z", x, y)).isCloseTo(ofRays.at("depth.Z", x, y), within(0.02f));
                assertThat(ofPaths.at("normal.Y", x, y)).isCloseTo(ofRays.at("normal.Y", x, y), within(0.02f));
                assertThat(ofPaths.at("albedo.B", x, y)).isCloseTo(ofRays.at("albedo.B", x, y), within(1e-5f));
            }
        }
        assertThat(inside).isGreaterThan(150);
    }

    /** At depth 1 all light is strewn once at most; what is beyond the first hit of a deeper picture is indirect. */
    @Test
    void directLightIsThatOfDepthOne() {
        Scene matt = SCENE.withObjects(List.of(SCENE.objects().get(0), SCENE.objects().get(3)));
        Layers layers = render(matt, RenderOptions.of(SETTINGS).withLayers(List.of(Layer.DIRECT))).layers();
        RenderResult once = render(matt, RenderOptions.of(SETTINGS.withMaxDepth(1)));
        for (int i = 0; i < 24 * 20; i++) {
            assertThat(layers.at("direct.R", i % 24, i / 24)).isCloseTo(once.image().red(i % 24, i / 24), within(1e-5f));
        }
    }

    @Test
    void anyThreadsAndAnyPartGiveTheSameLayers() {
        RenderOptions options = RenderOptions.of(SETTINGS.withSamples(64, 200)).withLayers(ALL).withTransparency();
        RenderResult whole = render(SCENE, options.withThreads(1));
        RenderResult part = render(SCENE, options.withThreads(3).withRegion(new Tile(5, 7, 17, 12)));
        for (int i = 0; i < 17 * 12; i++) {
            int x = i % 17;
            int y = i / 17;
            assertThat(part.image().alpha(x, y)).isEqualTo(whole.image().alpha(5 + x, 7 + y));
            assertThat(at(part, x, y)).isEqualTo(at(whole, 5 + x, 7 + y));
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"BOX", "MITCHELL"})
    void whoAsksForMorePathsLaterGetsTheLayersOfAllAtOnce(PixelFilter filter) {
        RenderSettings settings = SETTINGS.withSize(12, 9).withFilter(filter);
        PathPicturesTest.Kept kept = new PathPicturesTest.Kept();
        RenderScene scene = RenderScene.of(SCENE);
        for (int paths : new int[] {20, 100, 200}) {
            RenderOptions options = RenderOptions.of(settings.withSamples(paths)).withLayers(ALL).withTransparency();
            RenderResult later = Renderer.render(scene, options, RenderMonitor.NONE, kept);
            RenderResult atOnce = Renderer.render(scene, options, RenderMonitor.NONE);
            assertThat(Scenes.difference(later.image(), atOnce.image(), 0)).isZero();
            for (int i = 0; i < 12 * 9; i++) {
                int x = i % 12;
                int y = i / 12;
                assertThat(at(later, x, y)).isEqualTo(at(atOnce, x, y));
            }
        }
    }

    /** What is transparent is nothing, and what lies on its background is the picture. */
    @Test
    void onItsBackgroundATransparentPictureIsThePicture() {
        RenderOptions options = RenderOptions.of(SETTINGS);
        RenderResult opaque = render(SCENE, options);
        RenderResult transparent = render(SCENE, options.withTransparency());
        double background = SCENE.background().linearGreen();
        int partly = 0;
        for (int i = 0; i < 24 * 20; i++) {
            double alpha = transparent.image().alpha(i % 24, i / 24);
            assertThat(transparent.image().green(i % 24, i / 24) + (1 - alpha) * background).isCloseTo(opaque.image().green(i % 24, i / 24), within(1e-6));
            partly += alpha > 0 && alpha < 1 ? 1 : 0;
        }
        assertThat(partly).isPositive();
    }
}
