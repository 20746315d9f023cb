package cz.paprsek.fx.view.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.Screenshots;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.picture.UnfinishedPictures;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.render.fields.Remembered;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.Layers;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.property.SimpleObjectProperty;
import javafx.concurrent.Worker;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.image.PixelReader;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What can be done to a picture when it is finished: its noise taken out, its lights mixed anew. */
class FinishedPicturesTest {
    private static final PointLight KEY = new PointLight("key", new Vec3(2, 4, 3), Rgb.WHITE, 0.3, 0);
    private static final PointLight FILL = new PointLight("", new Vec3(-3, 2, 2), new Rgb(120, 160, 255), 0.2, 0);
    private static final RenderSettings PATHS = new RenderSettings(40, 30, 3, 1).withIntegrator(Integrator.PATH).withSamples(64);
    private static final Scene SCENE = Scene.EMPTY.withSettings(PATHS).withCamera(Camera.lookingAt(new Vec3(0, 1.5, 5), new Vec3(0, 0.5, 0))).withBackground(new Rgb(30, 50, 80))
            .withLights(List.of(KEY, FILL))
            .plus(SceneObject.of(new Rectangle(-4, -4, 4, 4)).rotated(-90, 0, 0).madeOf(Material.color(200, 120, 80)))
            .plus(SceneObject.of(new Sphere(0.6)).at(-0.5, 0.6, 0).madeOf(Material.color(250, 250, 250)));

    @TempDir
    static Path folder;

    private Optional<Path> saved = Optional.empty();
    private final EditorModel model = new EditorModel(SCENE);
    private final RenderPane pane = Gui.on(() -> pane(Locale.ENGLISH));
    private final Gui gui = Gui.show(() -> pane, 1000, 640);

    private RenderPane pane(Locale language) {
        return new RenderPane(model, new RenderDesk(Remembered.forNow(), UnfinishedPictures.notKept()), Texts.in(language), new SimpleObjectProperty<>(Theme.LIGHT), (owner, name) -> saved, (owner, name) -> Optional.empty());
    }

    @AfterEach
    void close() {
        gui.act(pane::cancelAll);
        gui.close();
    }

    @Test
    void aDenoisedPictureIsThatOfTheCommandLineAndIsComparedWithWhatItWas() {
        gui.act(pane::render);
        untilDone();
        assertThat(shown().getContent().lookup("#render-before").isVisible()).as("no noise was taken out").isFalse();
        gui.click("#render-ask");
        gui.click("#render-denoise");
        gui.click("#render-start");
        untilDone();
        assertThat(shown().task().options()).isEqualTo(RenderOptions.of(PATHS).withDenoiser());
        RenderProgress done = shown().task().progress();
        assertThat(done.tracingSeconds()).as("rays are not traced while the noise is taken out").isPositive().isLessThan(done.elapsedSeconds());
        assertThat(done.raysPerSecond()).isEqualTo(done.rays() / done.tracingSeconds());
        Image clean = Renderer.render(RenderScene.of(SCENE), RenderOptions.of(PATHS).withDenoiser(), RenderMonitor.NONE).image();
        Image noisy = Renderer.render(SCENE);
        assertThat(shown().task().image().orElseThrow().toLinear()).isEqualTo(clean.toLinear()).isNotEqualTo(noisy.toLinear());
        assertShows(shown().task().buffer().image().getPixelReader(), clean);
        assertShows(shown().task().noisy().orElseThrow().image().getPixelReader(), noisy);
        gui.act(() -> ((ToggleButton) shown().getContent().lookup("#render-before")).setSelected(true));
        assertThat(shown().view().lookup(".wipe").isVisible()).isTrue();
        assertThat(shown().task().saved(ImageFormat.PNG).origin().settings()).contains(" --denoise");
        assertThat(Screenshots.save(gui, "render-denoised")).isNotEmptyFile();
        RenderTab old = shown();
        gui.act(() -> pane(Locale.forLanguageTag("cs")).takeOver(pane));
        assertThat(old.view().lookup(".wipe").isVisible()).as("the old view compares no more").isFalse();
    }

    @Test
    void noiseIsTakenOutOfWholePassesOfPathsOnly() {
        gui.click("#render-ask");
        assertThat(gui.node("#render-denoise").isDisabled()).isFalse();
        gui.act(() -> ((TextField) gui.node("#render-samples")).setText("100"));
        assertThat(gui.node("#render-denoise").isDisabled()).isTrue();
        gui.act(() -> ((TextField) gui.node("#render-samples")).setText("128"));
        assertThat(gui.node("#render-denoise").isDisabled()).isFalse();
        gui.click("#render-mix");
        assertThat(gui.node("#render-denoise").isDisabled()).as("layers keep their noise").isTrue();
    }

    @Test
    void lightsAreMixedWithoutRenderingAgain() {
        gui.click("#render-ask");
        gui.click("#render-mix");
        gui.click("#render-start");
        untilDone();
        Image rendered = Renderer.render(SCENE);
        assertThat(shown().task().image().orElseThrow().toLinear()).isEqualTo(rendered.toLinear());
        gui.act(() -> ((Slider) gui.node("#mix-stops-0")).setValue(1));
        gui.click("#mix-shines-1");
        Scene wished = SCENE.withLights(List.of(KEY.withIntensity(0.6), FILL.withIntensity(0)));
        Image expected = Renderer.render(wished);
        gui.until("the lights are mixed", () -> isNear(expected));
        assertThat(shown().task().saved(ImageFormat.PNG).origin().settings()).endsWith(" --aov light; lights mixed afterwards: key × 2 2 2, 2 × 0 0 0");
        gui.until("it is shown", () -> Math.abs((shown().task().buffer().image().getPixelReader().getArgb(20, 25) >> 8 & 255) - (expected.argb(20, 25) >> 8 & 255)) <= 1);
        assertThat(Screenshots.save(gui, "render-mixed")).isNotEmptyFile();
        Path file = folder.resolve("mixed.exr");
        saved = Optional.of(file);
        gui.click("#render-save");
        gui.until("it is saved", () -> Files.exists(file));
        assertMixed(file, expected);
        gui.click("#render-mix-reset");
        gui.until("all is as it was rendered", () -> Arrays.equals(shown().task().image().orElseThrow().toLinear(), rendered.toLinear()));
        assertThat(shown().task().saved(ImageFormat.PNG).origin().settings()).endsWith(" --aov light");
    }

    /** The file holds what each light brings now, and can be mixed again. */
    private static void assertMixed(Path file, Image expected) {
        try {
            Layers layers = ImageFiles.readLayers(file);
            assertThat(layers.lights()).containsExactly("2", "key", "rest");
            assertThat(layers.image("light.2").toLinear()).containsOnly(0);
            assertThat((double) layers.image("light.key").red(20, 25) + layers.image("light.rest").red(20, 25)).isCloseTo(expected.red(20, 25), within(1e-3));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void lightsStayAsTheyAreSetAndAFailureIsTold() {
        gui.click("#render-ask");
        gui.click("#render-mix");
        gui.click("#render-start");
        untilDone();
        Mixer mixer = shown().task().mixer().orElseThrow();
        gui.act(() -> ((Slider) gui.node("#mix-stops-1")).setValue(-2));
        gui.click("#mix-shines-1");
        MixPane again = Gui.on(() -> new MixPane(SCENE, mixer, Texts.in(Locale.forLanguageTag("cs"))));
        assertThat(mixer.setting(mixer.lights().get(1))).isEqualTo(new Mixer.Setting(false, -2, Rgb.WHITE));
        gui.act(() -> mixer.set(mixer.lights().get(0), new Mixer.Setting(true, 200, Rgb.WHITE)));
        gui.until("it is told", () -> label(again).startsWith("Světla se nepodařilo smíchat: "));
        gui.act(mixer::reset);
        gui.until("the next wish is done", () -> label(again).isEmpty());
    }

    private static String label(MixPane pane) {
        return pane.getChildrenUnmodifiable().stream().filter(node -> "render-mix-failed".equals(node.getId())).map(node -> ((Label) node).getText()).findFirst().orElseThrow();
    }

    private boolean isNear(Image expected) {
        float[] now = shown().task().image().orElseThrow().toLinear();
        float[] then = expected.toLinear();
        double most = 0;
        for (int i = 0; i < now.length; i++) {
            most = Math.max(most, Math.abs(now[i] - then[i]));
        }
        return most < 1e-5;
    }

    private static void assertShows(PixelReader shown, Image image) {
        for (int i = 0; i < image.width() * image.height(); i++) {
            assertThat(shown.getArgb(i % image.width(), i / image.width())).isEqualTo(image.argb(i % image.width(), i / image.width()));
        }
    }

    private RenderTab shown() {
        return (RenderTab) ((TabPane) gui.node("#renders")).getSelectionModel().getSelectedItem();
    }

    private void untilDone() {
        gui.until("the picture is rendered", () -> shown().task().getState() == Worker.State.SUCCEEDED);
    }
}
