package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.Image;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderScene.Pick;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.TracedRay.Sight;
import cz.paprsek.render.explain.text.Decoration;
import cz.paprsek.render.explain.text.TreeText;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Whole pictures through every lens. */
class LensTest {
    private static final Camera CAMERA = Camera.lookingAt(new Vec3(0.4, 1.6, 5), new Vec3(0, 0.2, 0.4));

    static Stream<Lens> lenses() {
        return Stream.of(new Lens.Perspective(60, 0.3, 0), new Lens.Orthographic(5), new Lens.Spherical(), Lens.Fisheye.DEFAULT, new Lens.Fisheye(300));
    }

    private static Scene scene(Lens lens) throws Exception {
        return SceneFiles.read(Path.of("src/test/resources/crosscheck/combined-table.xml")).withCamera(CAMERA.withLens(lens))
                .withSettings(new RenderSettings(61, 43, 4, 3));
    }

    @ParameterizedTest
    @MethodSource("lenses")
    void anyThreadsAndRegionsGiveTheSameBytes(Lens lens) throws Exception {
        Scene scene = scene(lens);
        RenderOptions options = RenderOptions.of(scene);
        Image whole = Renderer.render(scene, options.withThreads(1), RenderMonitor.NONE).image();
        assertThat(Renderer.render(scene, options.withThreads(3), RenderMonitor.NONE).image().toArgb()).isEqualTo(whole.toArgb());
        Image part = Renderer.render(scene, options.withRegion(new Tile(13, 9, 30, 21)), RenderMonitor.NONE).image();
        for (int y = 0; y < 21; y++) {
            for (int x = 0; x < 30; x++) {
                assertThat(part.red(x, y)).isEqualTo(whole.red(x + 13, y + 9));
            }
        }
    }

    /** Bundles find what each ray finds by itself, and an explanation is the pixel bit for bit. */
    @ParameterizedTest
    @MethodSource("lenses")
    void theExplanationOfAPixelIsThePixel(Lens lens) throws Exception {
        Scene scene = scene(lens);
        Image image = Renderer.render(scene);
        RenderScene ready = RenderScene.of(scene);
        for (int i = 0; i < 61 * 43; i += 37) {
            Pixel pixel = ready.explain(i % 61, i / 61);
            assertThat((float) pixel.light().red()).isEqualTo(image.red(i % 61, i / 61));
            assertThat((float) pixel.light().green()).isEqualTo(image.green(i % 61, i / 61));
            assertThat((float) pixel.light().blue()).isEqualTo(image.blue(i % 61, i / 61));
            assertThat(pixel.rays()).allMatch(ray -> ray.sight().isPresent());
        }
    }

    @Test
    void whatIsInFocusIsAsThroughAPinhole() throws Exception {
        Scene wide = scene(new Lens.Perspective(40, 0.4, 0));
        Pixel pixel = RenderScene.of(wide).explain(30, 21);
        Vec3 target = ((Camera.Target) CAMERA.aim()).point();
        for (var ray : pixel.rays()) {
            Sight sight = ray.sight().orElseThrow();
            assertThat(sight.across() * sight.across() + sight.upwards() * sight.upwards()).isLessThanOrEqualTo(0.16);
            assertThat(sight.focus().orElseThrow().minus(target).dot(CAMERA.forward())).isCloseTo(0, within(1e-9));
        }
    }

    @Test
    void outsideOfTheFisheyesCircleTheExplanationSaysSo() throws Exception {
        Scene scene = scene(Lens.Fisheye.DEFAULT).withSettings(new RenderSettings(60, 40, 4, 1));
        String text = String.join("\n", TreeText.lines(RenderScene.of(scene).explain(0, 0), 0, Decoration.NONE));
        assertThat(text).contains("outside of the fisheye's circle: sees nothing").contains("in sRGB 0 0 0").doesNotContain("background");
        assertThat(Pick.at(RenderScene.of(scene), scene.settings(), 1, 1)).isEmpty();
    }

    /** A filter's rays start up to two pixels beyond the picture, where there may be glass that reaches no pixel of it. */
    @ParameterizedTest
    @EnumSource(PixelFilter.class)
    void theEdgeIsAsItIsInAWiderPicture(PixelFilter filter) throws Exception {
        Scene scene = SceneFiles.parse("<scene xmlns=\"urn:paprsek:scene:1\"><background color=\"white\"/>"
                + "<camera position=\"0 0 0\" direction=\"0 0 -1\" projection=\"orthographic\" height=\"16\"/><point-light position=\"0 0 9\"/>"
                + "<sphere position=\"-9.1 0 0\" radius=\"1\"><material diffusion=\"0\" transparency=\"0.5\" refractive-index=\"1.5\"/></sphere>"
                + "<sphere position=\"-9.1 0 -3\" radius=\"1\"/></scene>");
        RenderSettings settings = new RenderSettings(16, 16, 5, 4).withSamples(4, 4).withFilter(filter);
        Image narrow = Renderer.render(scene, RenderOptions.of(settings).withFixedSampler(), RenderMonitor.NONE).image();
        Image wide = Renderer.render(scene, RenderOptions.of(settings.withSize(22, 16)).withFixedSampler(), RenderMonitor.NONE).image();
        for (int row = 0; row < 16; row++) {
            assertThat(narrow.red(0, row)).as("row %d", row).isCloseTo(wide.red(3, row), within(1e-6f));
        }
    }

    /** A ray that starts inside of glass knows it, wherever on lens or plane that is. */
    @Test
    void raysOfOneEyeMayStartInDifferentMedia() throws Exception {
        Scene scene = SceneFiles.parse("<scene xmlns=\"urn:paprsek:scene:1\"><render width=\"40\" height=\"40\"/><background color=\"white\"/>"
                + "<camera position=\"0 0 0\" direction=\"0 0 -1\" projection=\"orthographic\" height=\"4\"/>"
                + "<sphere radius=\"1\"><material diffusion=\"0\" transparency=\"1\" refractive-index=\"1.5\"/></sphere></scene>");
        RenderScene ready = RenderScene.of(scene);
        assertThat(ready.explain(20, 20).rays().get(0).medium().refractiveIndex()).isEqualTo(1.5);
        assertThat(ready.explain(14, 20).rays().get(0).medium().refractiveIndex()).isEqualTo(1.5);
        assertThat(ready.explain(2, 20).rays().get(0).medium().refractiveIndex()).isEqualTo(1);
    }
}
