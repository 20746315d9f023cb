package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class LightMixTest {
    private static final Vec3 WHOLE = new Vec3(1, 1, 1);
    private static final PointLight KEY = new PointLight("key", new Vec3(2, 4, 3), Rgb.WHITE, 0.6, 0);
    private static final PointLight FILL = new PointLight("fill", new Vec3(-3, 2, 2), new Rgb(120, 160, 255), 0.3, 0);
    private static final Scene SCENE = Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 1.5, 5), new Vec3(0, 0.5, 0))).withBackground(new Rgb(30, 50, 80))
            .withLights(List.of(KEY, FILL))
            .plus(SceneObject.of(new Rectangle(-4, -4, 4, 4)).rotated(-90, 0, 0).madeOf(Material.color(200, 120, 80)))
            .plus(SceneObject.of(new Sphere(0.6)).at(-0.5, 0.6, 0).madeOf(Material.color(250, 250, 250).withDiffusion(0.3).withReflection(0.6)));

    private static RenderResult render(Scene scene, Integrator integrator) {
        RenderSettings settings = new RenderSettings(20, 16, 4, 1).withIntegrator(integrator).withSamples(integrator == Integrator.PATH ? 64 : 2);
        return Renderer.render(RenderScene.of(scene), RenderOptions.of(settings).withLayers(List.of(Layer.LIGHT)), RenderMonitor.NONE);
    }

    private static Image mixed(RenderResult result, Map<String, Vec3> shares) {
        return result.layers().mixed(result.image(), shares);
    }

    private static void assertSame(Image mixed, Image rendered) {
        for (int i = 0; i < 20 * 16; i++) {
            int x = i % 20;
            int y = i / 20;
            assertThat((double) mixed.red(x, y)).isCloseTo(rendered.red(x, y), within(2e-6));
            assertThat((double) mixed.green(x, y)).isCloseTo(rendered.green(x, y), within(2e-6));
            assertThat((double) mixed.blue(x, y)).isCloseTo(rendered.blue(x, y), within(2e-6));
        }
    }

    @ParameterizedTest
    @EnumSource(Integrator.class)
    void lightsMixedAfterwardsArePicturesRenderedWithThem(Integrator integrator) {
        RenderResult result = render(SCENE, integrator);
        assertThat(result.layers().lights()).containsExactly("key", "fill", "rest");
        assertSame(mixed(result, Map.of("key", new Vec3(2, 2, 2))), render(SCENE.withLights(List.of(KEY.withIntensity(1.2), FILL)), integrator).image());
        assertSame(mixed(result, Map.of("key", new Vec3(0, 0, 0), "fill", new Vec3(0.5, 0.5, 0.5))),
                render(SCENE.withLights(List.of(KEY.withIntensity(0), FILL.withIntensity(0.15))), integrator).image());
        Rgb amber = new Rgb(255, 180, 60);
        assertSame(mixed(result, Map.of("key", new Vec3(amber.linearRed(), amber.linearGreen(), amber.linearBlue()))),
                render(SCENE.withLights(List.of(new PointLight("key", new Vec3(2, 4, 3), amber, 0.6, 0), FILL)), integrator).image());
        assertSame(mixed(result, Map.of("rest", new Vec3(0, 0, 0))), render(SCENE.withBackground(Rgb.BLACK), integrator).image());
    }

    @Test
    void wholeSharesChangeNoBitAndNothingOfAllIsBlack() {
        RenderResult result = render(SCENE, Integrator.PATH);
        Vec3 none = new Vec3(0, 0, 0);
        assertThat(mixed(result, Map.of("key", WHOLE, "rest", WHOLE)).toLinear()).isEqualTo(result.image().toLinear());
        for (float light : mixed(result, Map.of("key", none, "fill", none, "rest", none)).toLinear()) {
            assertThat((double) light).isBetween(0.0, 1e-6);
        }
    }

    private static Image plane(Layers layers, String light) {
        return layers.image("light." + light);
    }

    /** What is as it was stays, light is as bright as in the picture, and what is of other light is left away. */
    @Test
    void layersThatStillHoldStay() {
        RenderSettings settings = new RenderSettings(20, 16, 4, 1).withIntegrator(Integrator.PATH).withSamples(64);
        RenderResult result = Renderer.render(RenderScene.of(SCENE), RenderOptions.of(settings).withLayers(List.of(Layer.values())), RenderMonitor.NONE);
        Layers layers = result.layers();
        Map<String, Vec3> shares = Map.of("key", new Vec3(2, 0, 1), "rest", new Vec3(0.5, 0.5, 0.5));
        Layers kept = layers.ofMix(shares);
        assertThat(layers.names()).containsAll(kept.names()).hasSize(kept.names().size() + 7).contains("error.V", "direct.R", "indirect.B");
        assertThat(kept.names()).noneMatch(name -> name.startsWith("error") || name.contains("direct"));
        for (String same : kept.names().stream().filter(name -> !name.startsWith("light.key") && !name.startsWith("light.rest")).toList()) {
            assertThat(kept.plane(same)).as(same).isEqualTo(layers.plane(same));
        }
        Image mixed = mixed(result, shares);
        for (int i = 0; i < 20 * 16; i++) {
            int x = i % 20;
            int y = i / 20;
            assertThat((double) mixed.red(x, y)).isCloseTo((double) plane(kept, "key").red(x, y) + plane(kept, "fill").red(x, y) + plane(kept, "rest").red(x, y), within(2e-6));
            assertThat(plane(kept, "key").green(x, y)).isZero();
        }
        // What is mixed back is what there was, but for what was away.
        assertThat(plane(kept.ofMix(Map.of("key", new Vec3(0.5, 1, 1), "rest", new Vec3(2, 2, 2))), "rest").toLinear()).isEqualTo(plane(layers, "rest").toLinear());
        assertThat(layers.ofMix(Map.of("key", WHOLE)).names()).isEqualTo(layers.names());
    }

    /** A picture of light that was exposed and toned as it was written, beside layers that were not. */
    @Test
    void whatWasExposedAndTonedIsMixedAsLight(@TempDir Path folder) throws Exception {
        RenderResult result = render(SCENE, Integrator.PATH);
        Map<String, Vec3> shares = Map.of("key", new Vec3(2, 0, 1));
        for (ImageOptions shown : List.of(ImageOptions.DEFAULT, ImageOptions.shown(1.5, Tone.NONE), ImageOptions.shown(-1, Tone.FILMIC))) {
            Path file = folder.resolve(shown.exposure() + ".exr");
            String settings = "--size 20x16" + (shown.exposure() == 0 ? "" : " --exposure " + shown.exposure()) + (shown.tone() == Tone.NONE ? "" : " --tone " + shown.tone());
            ImageFiles.write(result.image(), result.layers(), file, shown.withBits(32).withOrigin(new ImageOptions.Origin("lit", "digest", "paprsek", settings)));
            Layers read = ImageFiles.readLayers(file);
            assertThat(read.written()).isEqualTo(shown.withOrigin(new ImageOptions.Origin("lit", "digest", "paprsek", "--size 20x16")));
            assertSame(read.mixed(shares), mixed(result, shares));
        }
    }

    @Test
    void opacityStays() {
        Image picture = Image.ofTransparent(1, 1);
        picture.set(0, 0, 0.25, 0.5, 0.125, 0.5);
        Image lamp = new Image(1, 1);
        lamp.set(0, 0, 0.25, 0.25, 0.125);
        Image mixed = Layers.ofSize(1, 1).with("light.lamp", lamp).mixed(picture, Map.of("lamp", new Vec3(3, 0, 1)));
        assertThat(mixed.toLinear()).containsExactly(0.75f, 0.25f, 0.125f);
        assertThat(mixed.alpha(0, 0)).isEqualTo(0.5f);
    }

    @Test
    void whatCannotBeMixedIsRefused() {
        Image picture = new Image(1, 1);
        Layers layers = Layers.ofSize(1, 1).with("light.lamp", picture);
        assertThatThrownBy(() -> layers.mixed(picture, Map.of("sun", WHOLE))).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("light.sun.R");
        assertThatThrownBy(() -> layers.mixed(new Image(2, 1), Map.of())).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("2 × 1");
        assertThatThrownBy(() -> layers.mixed(picture, Map.of("lamp", new Vec3(-1, 0, 0)))).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("share of light lamp");
        assertThatThrownBy(() -> layers.mixed(picture, Map.of("lamp", new Vec3(0, Double.NaN, 0)))).isInstanceOf(IllegalArgumentException.class);
    }
}
