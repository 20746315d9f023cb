package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is known of pixels beside their light: opacity and layers. */
class LayersTest {
    private static final List<Layer> ALL = Stream.of(Layer.values()).filter(layer -> layer != Layer.ERROR).toList();

    private static RenderResult render(Scene scene, RenderOptions options) {
        return Renderer.render(RenderScene.of(scene), options, RenderMonitor.NONE);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void layersChangeNoBitOfThePicture(long seed) {
        Scene scene = Scenes.randomlySeen(seed, 20);
        RenderOptions options = RenderOptions.of(scene);
        RenderResult layered = render(scene, options.withLayers(ALL));
        assertThat(Scenes.difference(layered.image(), render(scene, options).image(), 0)).isZero();
        assertThat(layered.layers().names()).startsWith("normal.X", "normal.Y", "normal.Z", "albedo.R", "albedo.G", "albedo.B", "depth.Z", "object.ID",
                "direct.R", "direct.G", "direct.B", "indirect.R", "indirect.G", "indirect.B", "samples.N");
        boolean isSharpened = scene.settings().filter() == PixelFilter.MITCHELL;
        for (int y = 0; y < scene.settings().height() && !isSharpened; y++) {
            for (int x = 0; x < scene.settings().width(); x++) {
                double light = layered.image().red(x, y);
                assertThat(sumOfLights(layered.layers(), x, y)).as("of all lights").isCloseTo(light, within(1e-6 * (1 + light)));
                assertThat(layered.layers().at("direct.R", x, y) + (double) layered.layers().at("indirect.R", x, y)).as("direct and indirect").isCloseTo(light, within(1e-6 * (1 + light)));
            }
        }
    }

    static double sumOfLights(Layers layers, int x, int y) {
        return layers.names().stream().filter(name -> name.startsWith("light.") && name.endsWith(".R")).mapToDouble(name -> layers.at(name, x, y)).sum();
    }

    @Test
    void layersOfABallAreThoseOfItsFormula() {
        Scene scene = Scenes.empty().withBackground(Rgb.WHITE).plus(Light.at(0, 0, 5)).plus(SceneObject.of(new Block(new Vec3(8, 8, 0), new Vec3(9, 9, 1))))
                .plus(SceneObject.of(new Sphere(1)).madeOf(Scenes.matte(0.5, 0.8).withReflection(0.2)));
        Layers layers = render(scene, RenderOptions.of(scene).withLayers(ALL)).layers();
        int x = scene.settings().width() / 2;
        int y = scene.settings().height() / 2;
        assertThat(List.of(layers.at("normal.X", x, y), layers.at("normal.Y", x, y), layers.at("normal.Z", x, y))).containsExactly(0f, 0f, 1f);
        assertThat(layers.at("depth.Z", x, y)).isEqualTo(4);
        assertThat(layers.at("object.ID", x, y)).as("the second").isEqualTo(2);
        assertThat(layers.at("albedo.G", x, y)).isCloseTo(0.4f, within(1e-6f));
        assertThat(layers.at("direct.B", x, y)).isCloseTo(0.4f, within(1e-6f));
        assertThat(layers.at("indirect.B", x, y)).as("of the white background").isCloseTo(0.2f, within(1e-6f));
        assertThat(layers.at("samples.N", x, y)).isEqualTo(1);
        assertThat(layers.names()).allSatisfy(name -> assertThat(layers.at(name, 0, 0)).isEqualTo(name.startsWith("direct") || name.startsWith("samples") || name.startsWith("light.rest") ? 1 : 0));
    }

    @Test
    void theLightsThatAreSeenComeAfterTheObjects() {
        Scene scene = Scenes.empty().plus(SceneObject.of(new Sphere(0.1)).at(3, 0, 0)).plus(SphereLight.of(Vec3.ZERO, 1));
        Layers layers = render(scene, RenderOptions.of(scene).withLayers(List.of(Layer.OBJECT, Layer.DEPTH))).layers();
        assertThat(layers.at("object.ID", 16, 12)).isEqualTo(2);
        assertThat(layers.at("depth.Z", 16, 12)).isEqualTo(4);
    }

    /** What lies on something else is what lies on its background. */
    @ParameterizedTest
    @EnumSource(names = {"BOX", "TENT", "GAUSS"})
    void onItsBackgroundATransparentPictureIsThePicture(PixelFilter filter) {
        for (long seed = 1; seed <= 3; seed++) {
            Scene random = Scenes.random(seed, 12);
            Scene scene = random.withObjects(random.objects().subList(1, random.objects().size()))
                    .withSettings(random.settings().withSamples(3).withFilter(filter));
            Image opaque = render(scene, RenderOptions.of(scene)).image();
            Image transparent = render(scene, RenderOptions.of(scene).withTransparency()).image();
            double background = scene.background().linearRed();
            int partly = 0;
            for (int i = 0; i < 33 * 25; i++) {
                double alpha = transparent.alpha(i % 33, i / 33);
                assertThat(transparent.red(i % 33, i / 33) + (1 - alpha) * background).isCloseTo(opaque.red(i % 33, i / 33), within(1e-6));
                partly += alpha > 0 && alpha < 1 ? 1 : 0;
            }
            assertThat(partly).as("pixels at edges").isPositive();
        }
    }

    /** An edge through the middle of a pixel, parallel rays: two of four columns of rays meet the block. */
    @Test
    void opacityIsTheShareThatIsCovered() {
        Scene scene = Scene.EMPTY.withSettings(new RenderSettings(3, 3, 2, 4)).withCamera(Camera.looking(new Vec3(0, 0, 5), new Vec3(0, 0, -1)).withLens(new Lens.Orthographic(3)))
                .withAmbient(Rgb.WHITE).plus(SceneObject.of(new Block(new Vec3(0, -9, -1), new Vec3(9, 9, 0))).madeOf(Material.color(255, 255, 255).withDiffusion(0)));
        Image image = render(scene, RenderOptions.of(scene).withTransparency()).image();
        assertThat(List.of(image.alpha(0, 1), image.alpha(1, 1), image.alpha(2, 1))).containsExactly(0f, 0.5f, 1f);
        assertThat(List.of(image.red(0, 1), image.red(1, 1), image.red(2, 1))).containsExactly(0f, 0.5f, 1f);
    }

    /** Black on nothing looks like nothing, but is there: adaptive pixels are judged by what they cover as well. */
    @Test
    void aBlackBodysEdgeIsAsSmoothAsAWhiteOnes() {
        Scene scene = Scenes.empty().withSettings(Scenes.empty().settings().withSamples(2, 6)).plus(SceneObject.of(new Sphere(1)).madeOf(Material.color(0, 0, 0)));
        RenderResult result = render(scene, RenderOptions.of(scene).withTransparency().withLayers(List.of(Layer.SAMPLES)));
        boolean anyMore = false;
        for (int i = 0; i < 33 * 25; i++) {
            boolean isEdge = result.image().alpha(i % 33, i / 33) % 1 != 0;
            anyMore |= isEdge && result.layers().at("samples.N", i % 33, i / 33) > 4;
        }
        assertThat(anyMore).isTrue();
    }

    @Test
    void whatIsSeenInMirrorsAndThroughGlassStaysAndGlassIsOpaque() {
        Scene scene = Scenes.empty().withBackground(Rgb.WHITE).plus(SceneObject.of(new Sphere(1)).madeOf(Material.color(0, 0, 0).withTransparency(1, 1.5)));
        Image image = render(scene, RenderOptions.of(scene).withTransparency()).image();
        assertThat(image.alpha(16, 12)).isEqualTo(1);
        assertThat(image.red(16, 12)).isEqualTo(1);
        assertThat(image.alpha(0, 0)).isZero();
        assertThat(image.red(0, 0)).isZero();
    }

    @Test
    void anyThreadsAndAnyPartGiveTheSameLayers() {
        Scene random = Scenes.random(4, 20);
        Scene scene = random.withSettings(random.settings().withSamples(2, 4).withSize(70, 50));
        RenderOptions options = RenderOptions.of(scene).withLayers(ALL).withTransparency();
        RenderResult whole = render(scene, options.withThreads(1));
        RenderResult part = render(scene, options.withThreads(3).withRegion(new Tile(20, 10, 40, 37)));
        for (int i = 0; i < 40 * 37; i++) {
            int x = i % 40;
            int y = i / 40;
            assertThat(part.image().alpha(x, y)).isEqualTo(whole.image().alpha(20 + x, 10 + y));
            assertThat(part.layers().names()).allSatisfy(name -> assertThat(part.layers().at(name, x, y)).isEqualTo(whole.layers().at(name, 20 + x, 10 + y)));
        }
    }

    @Test
    void aPatternsColourIsTheAlbedo() {
        Scene scene = Scenes.empty().plus(SceneObject.of(new Sphere(1)).madeOf(Scenes.matte(1, 0.5).withPattern(new Pattern.Checker(100, Vec3.ZERO, Rgb.BLACK, Rgb.WHITE))));
        Layers layers = render(scene, RenderOptions.of(scene).withLayers(List.of(Layer.ALBEDO))).layers();
        assertThat(layers.at("albedo.R", 16, 12)).isIn(0f, 0.5f);
    }

    @Test
    void onlyPicturesOfLightHaveThem() {
        RenderOptions options = RenderOptions.of(RenderSettings.DEFAULT);
        assertThatThrownBy(() -> options.withMode(RenderMode.NORMALS).withTransparency()).hasMessage("layers and transparency are of pictures of light, not of normals");
        assertThatThrownBy(() -> options.withLayers(List.of(Layer.DEPTH, Layer.DEPTH))).hasMessageContaining("once");
        assertThatThrownBy(() -> options.withLayers(List.of(Layer.ERROR))).hasMessageContaining("samples A..B");
        assertThat(options.withTransparency().withLayers(ALL).channels(Scenes.empty().plus(Light.at(0, 0, 5)))).isEqualTo(25);
    }
}
