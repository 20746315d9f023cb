package cz.paprsek.fx.view.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Main;
import cz.paprsek.fx.Gui;
import cz.paprsek.fx.Screenshots;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.picture.UnfinishedPictures;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.render.fields.Remembered;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import javafx.beans.property.SimpleObjectProperty;
import javafx.concurrent.Worker;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RenderPaneTest {
    private static final Scene SCENE = Scene.EMPTY.withName("ball/1").withSettings(new RenderSettings(120, 80, 5, 1))
            .withCamera(Camera.lookingAt(new Vec3(0, 0, 6), Vec3.ZERO)).plus(Light.at(3, 5, 6))
            .plus(SceneObject.of(new Sphere(1)).named("ball").madeOf(Material.color(200, 60, 40)));

    private static final cz.paprsek.fx.model.Label DELETE = cz.paprsek.fx.model.Label.of(cz.paprsek.fx.model.Label.Edit.DELETE);
    private static final cz.paprsek.fx.model.Label CHANGE = cz.paprsek.fx.model.Label.of(cz.paprsek.fx.model.Label.Edit.CHANGE);

    @TempDir
    private Path folder = Path.of("");

    private final AtomicReference<String> suggested = new AtomicReference<>("");
    private final AtomicReference<Optional<Path>> answer = new AtomicReference<>(Optional.empty());
    private final EditorModel model = new EditorModel(SCENE);
    private final RenderPane pane = Gui.on(() -> new RenderPane(model, new RenderDesk(Remembered.forNow(), UnfinishedPictures.notKept()), Texts.in(Locale.ENGLISH), new SimpleObjectProperty<>(Theme.LIGHT), (owner, name) -> {
        suggested.set(name);
        return Objects.requireNonNull(answer.get());
    }, (owner, name) -> Optional.empty()));
    private final Gui gui = Gui.show(() -> pane, 900, 600);

    @AfterEach
    void close() {
        gui.act(pane::cancelAll);
        gui.close();
    }

    @Test
    void rendersAtTheSizeThatIsEnteredWhileTheSceneIsEdited() {
        enter("#render-width", "64");
        enter("#render-height", "48");
        enter("#render-samples", "2");
        start();
        gui.act(() -> model.edit(DELETE, scene -> scene.withObjects(List.of())));
        untilDone();
        Image expected = Renderer.render(SCENE.withSettings(new RenderSettings(64, 48, 5, 2)));
        Image rendered = shown().task().image().orElseThrow();
        for (int y = 0; y < 48; y++) {
            for (int x = 0; x < 64; x++) {
                assertThat(shown().task().buffer().image().getPixelReader().getArgb(x, y)).isEqualTo(expected.argb(x, y));
                assertThat(rendered.red(x, y)).isEqualTo(expected.red(x, y));
            }
        }
        assertThat(status()).startsWith("Done in").contains("rays/s");
    }

    /** As `render --exposure 1 --tone filmic --transparent` writes it. */
    @Test
    @SuppressWarnings("unchecked")
    void exposureToneAndTransparencyAreThoseOfTheCommandLine() throws IOException {
        gui.act(() -> model.edit(CHANGE, scene -> scene.withBackground(Rgb.WHITE)));
        gui.act(pane::render);
        untilDone();
        enter("#render-exposure", "1");
        gui.keys(KeyCode.UP);
        assertThat(text("#render-exposure")).isEqualTo("1.333");
        enter("#render-exposure", "101");
        assertThat(gui.node("#render-start").isDisabled()).isTrue();
        enter("#render-exposure", "1");
        ChoiceBox<Object> tone = (ChoiceBox<Object>) gui.node("#render-tone");
        gui.act(() -> tone.getSelectionModel().select(1));
        gui.click("#render-transparent");
        start();
        untilDone();
        Image expected = Renderer.render(RenderScene.of(model.scene()), RenderOptions.of(model.scene()).withTransparency(), RenderMonitor.NONE).image();
        ImageOptions how = ImageOptions.shown(1, Tone.FILMIC);
        assertThat(shown().task().buffer().image().getPixelReader().getArgb(60, 40)).isEqualTo(how.shown(expected).applyAsInt(60, 40)).isNotEqualTo(expected.argb(60, 40));
        assertThat(shown().task().buffer().image().getPixelReader().getArgb(0, 0)).isZero();
        assertThat(Screenshots.save(gui, "render-transparent")).isNotEmptyFile();
        Path file = folder.resolve("cut.png");
        answer.set(Optional.of(file));
        gui.click("#render-save");
        gui.until("saved", () -> Files.exists(file));
        assertThat(ImageIO.read(file.toFile()).getRGB(60, 40)).isEqualTo(how.shown(expected).applyAsInt(60, 40));
        assertThat(ImageIO.read(file.toFile()).getRGB(0, 0)).isZero();
    }

    @Test
    void aPresetFillsInTheSizeAndNumbersOutOfRangeAreRefused() {
        ask();
        gui.click("#render-presets");
        gui.keys(KeyCode.DOWN);
        gui.keys(KeyCode.ENTER);
        assertThat(text("#render-width") + "x" + text("#render-height")).isEqualTo("320x240");
        enter("#render-samples", "17");
        assertThat(gui.node("#render-start").isDisabled()).isTrue();
        gui.keys(KeyCode.DOWN);
        assertThat(text("#render-samples")).isEqualTo("1");
        assertThat(gui.node("#render-start").isDisabled()).isFalse();
    }

    @Test
    @SuppressWarnings("unchecked")
    void raysAreChosenAsOnTheCommandLine() {
        Scene asks = SCENE.withSettings(SCENE.settings().withSamples(2, 4).withError(0.02).withConfidence(0.9).withFilter(PixelFilter.TENT));
        gui.act(() -> model.edit(CHANGE, scene -> asks));
        gui.act(pane::render);
        untilDone();
        assertThat(shown().task().options()).isEqualTo(RenderOptions.of(asks));
        assertThat(text("#render-error") + " " + text("#render-confidence")).isEqualTo("0.02 0.9");
        enter("#render-error", "1/255");
        enter("#render-confidence", "0.99");
        gui.act(() -> ((ChoiceBox<Object>) gui.node("#render-filter")).getSelectionModel().select(3));
        gui.act(() -> ((ChoiceBox<Object>) gui.node("#render-sampler")).getSelectionModel().select(1));
        start();
        untilDone();
        RenderSettings wished = asks.settings().withError(1 / 255.0).withConfidence(0.99).withFilter(PixelFilter.MITCHELL);
        assertThat(shown().task().options()).isEqualTo(RenderOptions.of(wished).withFixedSampler());
        Image expected = Renderer.render(RenderScene.of(asks), RenderOptions.of(wished).withFixedSampler(), RenderMonitor.NONE).image();
        assertThat(shown().task().image().orElseThrow().red(60, 40)).isEqualTo(expected.red(60, 40));
        enter("#render-confidence", "1");
        assertThat(gui.node("#render-start").isDisabled()).as("certain is nothing").isTrue();
        enter("#render-confidence", "0.5");
        enter("#render-error", "1/");
        assertThat(gui.node("#render-start").isDisabled()).isTrue();
        enter("#render-error", "0.5");
        enter("#render-most-samples", "0");
        assertThat(gui.node("#render-error").isDisabled()).as("a grid is not judged").isTrue();
        assertThat(gui.node("#render-start").isDisabled()).isFalse();
    }

    @Test
    @SuppressWarnings("unchecked")
    void pathsAreChosenAsOnTheCommandLine() {
        ask();
        ChoiceBox<Object> integrator = (ChoiceBox<Object>) gui.node("#render-integrator");
        ChoiceBox<Object> mode = (ChoiceBox<Object>) gui.node("#render-mode");
        gui.act(() -> integrator.getSelectionModel().select(1));
        assertThat(text("#render-samples") + " " + text("#render-most-samples")).as("as many as whoever says nothing gets").isEqualTo("64 0");
        enter("#render-width", "24");
        enter("#render-height", "16");
        enter("#render-samples", "1000001");
        assertThat(gui.node("#render-start").isDisabled()).isTrue();
        enter("#render-samples", "100");
        assertThat(gui.node("#render-transparent").isDisabled()).isFalse();
        start();
        untilDone();
        RenderSettings wished = SCENE.settings().withSize(24, 16).withIntegrator(Integrator.PATH).withSamples(100);
        assertThat(shown().task().options()).isEqualTo(RenderOptions.of(wished));
        Image expected = Renderer.render(RenderScene.of(SCENE), RenderOptions.of(wished), RenderMonitor.NONE).image();
        assertThat(shown().task().image().orElseThrow().red(12, 8)).isEqualTo(expected.red(12, 8));
        ask();
        gui.act(() -> mode.getSelectionModel().selectLast());
        start();
        untilDone();
        assertThat(gui.node("#render-scale").isVisible()).as("what the colours of errors stand for").isTrue();
        assertThat(shown().statusProperty().get()).contains("of the pixels within the error, the farthest");
        ask();
        gui.act(() -> integrator.getSelectionModel().select(0));
        assertThat(text("#render-samples")).isEqualTo("1");
        assertThat(gui.node("#render-mode-refusal").isVisible()).as("a grid is not judged").isTrue();
        assertThat(gui.node("#render-start").isDisabled()).isTrue();
        enter("#render-most-samples", "4");
        assertThat(gui.node("#render-start").isDisabled()).isFalse();
    }

    @Test
    @SuppressWarnings("unchecked")
    void aPictureToLearnFromAndOneOfOneLight() {
        ask();
        ChoiceBox<Object> mode = (ChoiceBox<Object>) gui.node("#render-mode");
        ChoiceBox<Object> lights = (ChoiceBox<Object>) gui.node("#render-lights");
        assertThat(mode.getItems()).extracting(Object::toString).contains("Normals", "Depth", "Rays per pixel (heat map)");
        gui.click("#render-ask-cancel");
        gui.act(() -> model.edit(CHANGE, scene -> scene.plus(Light.at(-3, 5, 6).named("left"))));
        gui.act(pane::render);
        untilDone();
        ask();
        gui.act(() -> mode.getSelectionModel().select(4));
        gui.act(() -> lights.getSelectionModel().select(2));
        start();
        untilDone();
        assertThat(shown().getText()).isEqualTo("2: ball/1 · 120 × 80 · Rays per pixel (heat map) · 2: left");
        assertThat(gui.node("#render-scale")).isNotNull();
        Scene onlyLeft = model.scene().withLights(model.scene().lights().subList(1, 2));
        Image expected = Renderer.render(RenderScene.of(onlyLeft), RenderOptions.of(onlyLeft).withMode(RenderMode.RAYS), RenderMonitor.NONE).image();
        assertThat(shown().task().buffer().image().getPixelReader().getArgb(60, 40)).isEqualTo(expected.argb(60, 40));
        assertThat(Screenshots.save(gui, "render-modes")).isNotEmptyFile();
    }

    @Test
    @SuppressWarnings("unchecked")
    void thePictureOfAnotherCameraIsThatOfTheCommandLine() {
        Camera side = Camera.lookingAt(new Vec3(6, 1, 0), Vec3.ZERO).named("side");
        ask();
        assertThat(gui.node("#render-camera").isDisabled()).as("nothing to choose").isTrue();
        gui.act(() -> model.edit(CHANGE, scene -> scene.withCameras(List.of(scene.camera().named("front"), side))));
        ChoiceBox<Object> camera = (ChoiceBox<Object>) gui.node("#render-camera");
        gui.act(() -> model.look(1));
        assertThat(Gui.on(() -> camera.getValue().toString())).as("the one looked through").isEqualTo("2: side");
        start();
        untilDone();
        assertThat(shown().getText()).isEqualTo("1: ball/1 · 120 × 80 · side");
        Image expected = Renderer.render(model.scene().through("side"));
        assertThat(shown().task().image().orElseThrow().red(60, 40)).isEqualTo(expected.red(60, 40));
        assertThat(shown().task().buffer().image().getPixelReader().getArgb(50, 40)).isEqualTo(expected.argb(50, 40));
        assertThat(model.scene().camera().name()).as("the scene stays").isEqualTo("front");
    }

    @Test
    void cancellingKeepsWhatIsDone() {
        enter("#render-width", "2000");
        enter("#render-height", "1500");
        enter("#render-samples", "16");
        start();
        gui.until("some tiles are done", () -> shown().task().progress().done() > 3);
        assertThat(status()).contains("%");
        gui.click("#render-cancel");
        assertThat(Gui.on(() -> shown().task().getState())).isEqualTo(Worker.State.CANCELLED);
        gui.until("the workers have stopped", () -> shown().task().isStopped());
        int done = shown().task().progress().done();
        assertThat(done).isLessThan(shown().task().progress().total());
        assertThat(status()).startsWith("Cancelled at");
        Image firstTile = Renderer.render(RenderScene.of(SCENE), shown().task().options().withRegion(new Tile(0, 0, 32, 32)), RenderMonitor.NONE).image();
        assertThat(shown().task().image().orElseThrow().argb(5, 5)).isEqualTo(firstTile.argb(5, 5));
    }

    @Test
    void escapeCancelsThePictureThatIsShown() {
        enter("#render-width", "2000");
        enter("#render-height", "1500");
        enter("#render-samples", "16");
        start();
        start();
        gui.act(() -> tabs().getSelectionModel().select(0));
        gui.keys(KeyCode.ESCAPE);
        assertThat(Gui.on(() -> shown().task().getState())).isEqualTo(Worker.State.CANCELLED);
        assertThat(Gui.on(() -> ((RenderTab) tabs().getTabs().get(1)).task().isDone())).isFalse();
    }

    @Test
    void savesThePictureInTheFormatOfTheFilesName() throws IOException {
        gui.act(pane::render);
        untilDone();
        Path png = folder.resolve("a.png");
        answer.set(Optional.of(png));
        gui.click("#render-save");
        gui.until("the picture is saved", () -> message().equals("a.png saved"));
        assertThat(suggested.get()).isEqualTo("ball-1.png");
        BufferedImage read = ImageIO.read(png.toFile());
        assertThat(read.getRGB(60, 40)).isEqualTo(Renderer.render(SCENE).argb(60, 40));
        Path text = folder.resolve("a.txt");
        answer.set(Optional.of(text));
        gui.click("#render-save");
        gui.until("the text is saved", () -> message().equals("a.txt saved"));
        assertThat(Files.readAllLines(text)).hasSize(80);
        answer.set(Optional.of(folder.resolve("none").resolve("a.png")));
        gui.click("#render-save");
        gui.until("the failure is told", () -> message().contains("could not be saved"));
    }

    /** Camera, light, size and the scene's digest: the bytes are those of the command line. */
    @ParameterizedTest
    @ValueSource(strings = {"png", "exr"})
    @SuppressWarnings("unchecked")
    void aSavedPictureTellsOfItselfWhatTheCommandLinesTells(String ending) throws Exception {
        Camera side = Camera.lookingAt(new Vec3(6, 1, 0), Vec3.ZERO);
        gui.act(() -> model.edit(CHANGE, scene -> scene.withCameras(List.of(scene.camera().named("front"), side)).plus(Light.at(-3, 5, 6).named("lamp"))));
        gui.act(pane::render);
        gui.act(() -> model.look(1));
        ask();
        gui.act(() -> ((ChoiceBox<Object>) gui.node("#render-lights")).getSelectionModel().select(2));
        enter("#render-width", "64");
        enter("#render-height", "48");
        start();
        untilDone();
        Path saved = folder.resolve("saved." + ending);
        answer.set(Optional.of(saved));
        gui.click("#render-save");
        gui.until("the picture is saved", () -> message().equals("saved." + ending + " saved"));
        Path scene = folder.resolve("scene.xml");
        SceneFiles.write(model.scene(), scene);
        Path expected = folder.resolve("expected." + ending);
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"),
                Main.class.getName(), "render", scene.toString(), "--camera", "2", "--light", "lamp", "--size", "64x48", "-o", expected.toString(), "--quiet").inheritIO().start();
        assertThat(process.waitFor()).isZero();
        assertThat(saved).hasSameBinaryContentAs(expected);
        assertThat(Files.readString(saved, StandardCharsets.ISO_8859_1)).contains("scene sha256 ", "--size 64x48 --samples 1 --max-depth 5 --camera 2 --light lamp");
    }

    /** Opens the dialog, unless it is open. */
    private void ask() {
        if (!isAsked()) {
            gui.click("#render-ask");
        }
    }

    private boolean isAsked() {
        return Gui.on(() -> pane.lookup("#render-dialog").isVisible());
    }

    /** Renders what the dialog says, or what was said last. */
    private void start() {
        gui.click(isAsked() ? "#render-start" : "#render-again");
    }

    private void enter(String field, String text) {
        ask();
        gui.click(field);
        gui.act(() -> ((TextField) gui.stage().getScene().lookup(field)).setText(text));
    }

    private void untilDone() {
        gui.until("the picture is done", () -> shown().task().getState() == Worker.State.SUCCEEDED);
    }

    private RenderTab shown() {
        return (RenderTab) tabs().getSelectionModel().getSelectedItem();
    }

    private TabPane tabs() {
        return (TabPane) pane.lookup("#renders");
    }

    private String status() {
        return label("#render-status");
    }

    /** For JavaFX's thread. */
    private String message() {
        return ((Label) pane.lookup("#render-message")).getText();
    }

    private String text(String selector) {
        return Gui.on(() -> ((TextField) pane.lookup(selector)).getText());
    }

    private String label(String selector) {
        return Gui.on(() -> ((Label) pane.lookup(selector)).getText());
    }
}
