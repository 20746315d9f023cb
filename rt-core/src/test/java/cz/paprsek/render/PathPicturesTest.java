package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.film.Film;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures of paths are the same however they come about. */
class PathPicturesTest {
    private static final RenderSettings SETTINGS = new RenderSettings(44, 36, 4, 1).withIntegrator(Integrator.PATH).withSamples(20);
    private static final Scene SCENE = Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 1, 4), new Vec3(0, 0.5, 0)))
            .withBackground(new Rgb(40, 60, 90)).withLights(List.of(SphereLight.of(new Vec3(1, 3, 1), 0.5).withIntensity(2)))
            .plus(SceneObject.of(new Rectangle(-3, -3, 3, 3)).rotated(-90, 0, 0)).plus(SceneObject.of(new Sphere(0.6)).at(0, 0.6, 0));

    private static Image picture(RenderOptions options) {
        return Renderer.render(RenderScene.of(SCENE), options, RenderMonitor.NONE).image();
    }

    private static List<Float> light(Image image) {
        List<Float> light = new ArrayList<>();
        for (int i = 0; i < image.width() * image.height(); i++) {
            int x = i % image.width();
            int y = i / image.width();
            light.addAll(List.of(image.red(x, y), image.green(x, y), image.blue(x, y)));
        }
        return light;
    }

    /** Each of the two hits of a path gives a share a of what comes, and 0.3·a + 0.6 of what comes there. */
    @Test
    void aCameraWithinAMirrorSeesWhatLightIsThere() {
        Material mirror = Material.color(Rgb.ofLinear(0.5, 0.5, 0.5)).withDiffusion(0.3).withReflection(0.6);
        Scene within = Scene.EMPTY.withCamera(Camera.lookingAt(Vec3.ZERO, new Vec3(0, 0, -1))).withAmbient(Rgb.WHITE).plus(SceneObject.of(new Sphere(5)).madeOf(mirror));
        Image image = Renderer.render(RenderScene.of(within), RenderOptions.of(SETTINGS.withSize(9, 7).withSamples(64).withMaxDepth(2)), RenderMonitor.NONE).image();
        assertThat(light(image).stream().mapToDouble(x -> x).average()).hasValueCloseTo(0.5 + 0.5 * 0.75, within(0.005));
    }

    @Test
    void anyNumberOfThreadsAndAnyRegionGiveTheSameBytes() {
        RenderOptions options = RenderOptions.of(SETTINGS);
        Image whole = picture(options.withThreads(1));
        for (int threads = 2; threads <= 4; threads++) {
            assertThat(light(picture(options.withThreads(threads)))).isEqualTo(light(whole));
        }
        Image part = picture(options.withRegion(new Tile(13, 7, 20, 21)));
        for (int i = 0; i < 20 * 21; i++) {
            assertThat(part.red(i % 20, i / 20)).isEqualTo(whole.red(13 + i % 20, 7 + i / 20));
        }
    }

    /** Each with several passes, the last of them not a whole one, and a filter that takes away. */
    @ParameterizedTest
    @EnumSource(value = PixelFilter.class, names = {"BOX", "MITCHELL"})
    void whoAsksForMorePathsLaterGetsWhatHeWouldHaveGotAtOnce(PixelFilter filter) {
        RenderSettings settings = SETTINGS.withSize(12, 9).withFilter(filter);
        Kept kept = new Kept();
        RenderScene scene = RenderScene.of(SCENE);
        for (int paths : new int[] {100, 150, 200}) {
            RenderOptions options = RenderOptions.of(settings.withSamples(paths));
            Image later = Renderer.render(scene, options, RenderMonitor.NONE, kept).image();
            assertThat(light(later)).isEqualTo(light(Renderer.render(scene, options, RenderMonitor.NONE).image()));
        }
        assertThat(kept.traced).isEqualTo(6);
    }

    /** Of a picture that stops pixel by pixel as well. */
    @Test
    void pixelsThatAreNearEnoughGetNoMore() {
        RenderSettings settings = SETTINGS.withSize(12, 9).withSamples(64, 1024).withError(0.02);
        Kept kept = new Kept();
        RenderScene scene = RenderScene.of(SCENE);
        Renderer.render(scene, RenderOptions.of(settings.withSamples(64, 200)), RenderMonitor.NONE, kept);
        Image later = Renderer.render(scene, RenderOptions.of(settings), RenderMonitor.NONE, kept).image();
        RenderResult atOnce = Renderer.render(scene, RenderOptions.of(settings), RenderMonitor.NONE);
        assertThat(light(later)).isEqualTo(light(atOnce.image()));
        assertThat(atOnce.stats().primary()).isBetween(64L * 12 * 9 + 1, 1024L * 12 * 9 - 1);
    }

    @Test
    void eachPassMakesThePictureThatAsManyPathsMake() {
        List<List<Float>> seen = new ArrayList<>();
        RenderMonitor watching = new RenderMonitor() {
            @Override
            public boolean passed(Image image, Supplier<Layers> layers, int passes) {
                seen.add(light(image));
                return passes < 3;
            }
        };
        RenderScene scene = RenderScene.of(SCENE);
        RenderSettings settings = SETTINGS.withSize(9, 7);
        RenderResult ended = Renderer.render(scene, RenderOptions.of(settings.withSamples(1000)), watching);
        assertThat(seen).hasSize(3);
        assertThat(ended.outcome()).isEqualTo(RenderResult.Outcome.DONE);
        for (int passes = 1; passes <= 3; passes++) {
            assertThat(seen.get(passes - 1)).isEqualTo(light(picture(RenderOptions.of(settings.withSamples(64 * passes)))));
        }
        assertThat(light(ended.image())).isEqualTo(seen.get(2));
    }

    /** Not of passes, of which there may be many more than it takes. */
    @Test
    void progressIsTheShareOfPixelsThatNeedNoMore() {
        List<Integer> told = new ArrayList<>();
        RenderMonitor watching = new RenderMonitor() {
            @Override
            public synchronized void finished(Tile tile, Image image, int done, int total) {
                assertThat(total).isEqualTo(4);
                told.add(done);
            }
        };
        RenderSettings settings = SETTINGS.withSize(64, 64).withSamples(64, 1 << 14).withError(0.05);
        Renderer.render(RenderScene.of(SCENE), RenderOptions.of(settings).withThreads(1), watching);
        assertThat(told).isSorted().hasSizeGreaterThan(8).startsWith(0);
        assertThat(told.get(told.size() - 1)).as("nearly all, in the last pass").isGreaterThanOrEqualTo(3);
    }

    @Test
    void aMonitorThatThrowsBetweenPassesEndsThePicture() {
        RenderMonitor throwing = new RenderMonitor() {
            @Override
            public boolean passed(Image image, Supplier<Layers> layers, int passes) {
                throw new ArithmeticException("between");
            }
        };
        assertThatThrownBy(() -> Renderer.render(RenderScene.of(SCENE), RenderOptions.of(SETTINGS.withSize(4, 3).withSamples(65)), throwing))
                .isInstanceOf(IllegalStateException.class).hasMessageContaining("between");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 16})
    void whatAnIntegratorDoesNotDoIsRefused(int samples) {
        RenderOptions options = RenderOptions.of(SETTINGS.withSamples(samples));
        assertThatThrownBy(() -> RenderScene.of(SCENE).explain(options, 1, 1)).hasMessageContaining("explained as paths");
        assertThatThrownBy(() -> SETTINGS.withSamples(RenderSettings.MOST_PATHS + 1)).hasMessageContaining("1000000");
        assertThatThrownBy(() -> RenderSettings.DEFAULT.withSamples(64)).hasMessageContaining("16");
    }

    /** A store that counts how often it was given something. */
    static final class Kept implements TileStore {
        private final Map<Tile, float[]> tiles = new HashMap<>();
        private int traced;

        @Override
        public synchronized boolean load(Tile tile, int pass, Film into) {
            float[] known = tiles.get(tile);
            if (known == null) {
                return false;
            }
            int channels = into.channels();
            for (int i = 0; i < tile.width() * tile.height(); i++) {
                float[] pixel = new float[channels];
                System.arraycopy(known, channels * i, pixel, 0, channels);
                into.setChannels(tile.x() + i % tile.width(), tile.y() + i / tile.width(), pixel);
            }
            return true;
        }

        @Override
        public synchronized void save(Tile tile, int pass, Film from) {
            traced++;
            int channels = from.channels();
            float[] values = new float[channels * tile.width() * tile.height()];
            for (int i = 0; i < values.length; i++) {
                int pixel = i / channels;
                values[i] = from.channel(i % channels, tile.x() + pixel % tile.width(), tile.y() + pixel / tile.width());
            }
            tiles.put(tile, values);
        }
    }
}
