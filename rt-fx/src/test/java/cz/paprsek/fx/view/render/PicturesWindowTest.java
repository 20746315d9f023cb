package cz.paprsek.fx.view.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.Gui;
import cz.paprsek.fx.Screenshots;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.file.Settings;
import cz.paprsek.fx.model.picture.UnfinishedPictures;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.render.fields.Remembered;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Sphere;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.IntStream;
import javafx.beans.property.SimpleObjectProperty;
import javafx.concurrent.Worker;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How renders are asked for, wait for each other, are cut, go on and are compared. */
class PicturesWindowTest {
    private static final RenderSettings PATHS = new RenderSettings(120, 80, 5, 1).withIntegrator(Integrator.PATH).withSamples(64);
    private static final Scene SCENE = Scene.EMPTY.withName("ball").withSettings(new RenderSettings(120, 80, 5, 1))
            .withCamera(Camera.lookingAt(new Vec3(0, 0, 6), Vec3.ZERO)).plus(Light.at(3, 5, 6))
            .plus(SceneObject.of(new Sphere(1)).named("ball").madeOf(Material.color(200, 60, 40)));
    private static final cz.paprsek.fx.model.Label CHANGE = cz.paprsek.fx.model.Label.of(cz.paprsek.fx.model.Label.Edit.CHANGE);

    @TempDir
    private Path folder = Path.of("");

    private final EditorModel model = new EditorModel(SCENE);
    private final RenderDesk desk = new RenderDesk(Remembered.forNow(), UnfinishedPictures.notKept());
    private final RenderPane pane = Gui.on(() -> pane(desk));
    private final Gui gui = Gui.show(() -> pane, 1000, 640);

    private RenderPane pane(RenderDesk at) {
        return new RenderPane(model, at, Texts.in(Locale.ENGLISH), new SimpleObjectProperty<>(Theme.LIGHT), (owner, name) -> Optional.empty(), (owner, name) -> Optional.empty());
    }

    @AfterEach
    void close() {
        gui.act(pane::cancelAll);
        gui.close();
    }

    @Test
    void whatWasSaidLastCountsForTheNextRenderAndTheNextStart() {
        gui.act(pane::ask);
        gui.click("#render-chain");
        enter("#render-width", "60");
        assertThat(((TextField) gui.node("#render-height")).getText()).as("the chain keeps the proportions").isEqualTo("40");
        enter("#render-samples", "99");
        assertThat(label("#render-samples-refusal")).as("what is wrong, below the field").contains("(1–16)");
        assertThat(gui.node("#render-start").isDisabled()).isTrue();
        enter("#render-samples", "2");
        gui.keys(KeyCode.ENTER);
        untilDone();
        assertThat(shown().task().options()).isEqualTo(RenderOptions.of(SCENE.settings().withSize(60, 40).withSamples(2)));
        assertThat(shown().getText()).isEqualTo("1: ball · 60 × 40");
        gui.act(() -> model.edit(CHANGE, scene -> scene.withSettings(scene.settings().withMaxDepth(3))));
        gui.keys(KeyCode.CONTROL, KeyCode.R);
        untilDone();
        assertThat(shown().task().options()).as("the scene says the rest").isEqualTo(RenderOptions.of(SCENE.settings().withSize(60, 40).withSamples(2).withMaxDepth(3)));
        Settings settings = new Settings(folder, fault -> {});
        Remembered.kept(settings.get("render"), text -> settings.set("render", text), Set.of("mode")).set(Map.of("size", "60x40", "camera", "two words & more", "mode", "depth"));
        assertThat(Remembered.kept(new Settings(folder, fault -> {}).get("render"), text -> {}, Set.of("mode")).answers()).containsExactlyInAnyOrderEntriesOf(Map.of("size", "60x40", "camera", "two words & more"));
        gui.act(pane::ask);
        gui.click("#render-ask-as-scene");
        assertThat(((TextField) gui.node("#render-width")).getText()).isEqualTo("120");
        gui.keys(KeyCode.ESCAPE);
        assertThat(desk.said().answers()).as("nothing was said").containsEntry("size", "60x40");
    }

    @Test
    void picturesWaitForTheirTurnWithTheSceneAsItWas() {
        AtomicBoolean shut = new AtomicBoolean(true);
        model.edit(CHANGE, scene -> scene.withSettings(PATHS.withSize(600, 400)).plus(SceneObject.of(new Gate(shut::get))));
        gui.act(pane::render);
        gui.act(() -> model.edit(CHANGE, scene -> SCENE.withSettings(PATHS.withSize(20, 10)).withName("second")));
        gui.act(pane::render);
        gui.act(() -> model.edit(CHANGE, scene -> scene.withSettings(PATHS.withSize(30, 20)).withName("third")));
        gui.act(pane::render);
        gui.act(() -> model.edit(CHANGE, scene -> SCENE));
        gui.until("the first runs", () -> task(0).getState() == Worker.State.RUNNING);
        assertThat(shown().task()).as("what runs stays in sight").isSameAs(task(0));
        assertThat(Gui.on(() -> ((RenderTab) tabs().getTabs().get(2)).statusProperty().get())).isEqualTo("Waits for its turn");
        ListView<?> list = (ListView<?>) gui.node("#render-queue-list");
        gui.act(() -> {
            list.requestFocus();
            list.getSelectionModel().select(2);
        });
        gui.hold(KeyCode.ALT);
        gui.keys(KeyCode.UP);
        gui.letGo(KeyCode.ALT);
        assertThat(Gui.on(() -> desk.queue().stream().map(RenderTask::title).toList())).containsExactly("1: ball · 600 × 400", "3: third · 30 × 20", "2: second · 20 × 10");
        assertThat(gui.node("#render-queue-up").isDisabled()).as("the one under way stays").isTrue();
        assertThat(Screenshots.save(gui, "render-queue")).isNotEmptyFile();
        gui.act(() -> list.getSelectionModel().select(0));
        gui.click("#render-queue-cancel");
        shut.set(false);
        gui.until("the others are done by themselves", () -> task(1).getState() == Worker.State.SUCCEEDED && task(2).getState() == Worker.State.SUCCEEDED);
        assertThat(Gui.on(() -> task(0).getState())).isEqualTo(Worker.State.CANCELLED);
        assertThat(task(1).image().orElseThrow().toLinear()).isEqualTo(Renderer.render(SCENE.withSettings(PATHS.withSize(20, 10))).toLinear());
        assertThat(desk.queue()).isEmpty();
    }

    @Test
    void aDraggedRectangleIsRenderedAloneUntilEscape() {
        gui.act(pane::render);
        untilDone();
        gui.click("#render-region-drag-toggle");
        Node view = shown().view();
        double zoom = shown().view().zoomProperty().get();
        double left = (view.getLayoutBounds().getWidth() - 120 * zoom) / 2;
        double top = (view.getLayoutBounds().getHeight() - 80 * zoom) / 2;
        gui.drag(view, left + 30.5 * zoom, top + 20.5 * zoom, left + 89.5 * zoom, top + 59.5 * zoom);
        assertThat(label(".region-numbers")).isEqualTo("30, 20 · 60 × 40");
        gui.keys(KeyCode.RIGHT);
        assertThat(label(".region-numbers")).isEqualTo("31, 20 · 60 × 40");
        gui.click("#render-again");
        untilDone();
        assertThat(shown().getText()).isEqualTo("2: ball · 120 × 80 · part 31, 20 · 60 × 40");
        RenderOptions part = RenderOptions.of(SCENE).withRegion(new Tile(31, 20, 60, 40));
        assertThat(shown().task().options()).isEqualTo(part);
        assertThat(shown().task().image().orElseThrow().toLinear()).isEqualTo(Renderer.render(RenderScene.of(SCENE), part, RenderMonitor.NONE).image().toLinear());
        assertThat(shown().task().saved(ImageFormat.PNG).origin().settings()).contains(" --region 31,20,60,40");
        gui.moveTo(shown().view(), shown().view().getWidth() / 2, shown().view().getHeight() / 2);
        assertThat(label("#pixel-text")).as("pixels of the whole picture").startsWith("61, 40").endsWith("ball");
        gui.act(() -> shown().view().requestFocus());
        gui.keys(KeyCode.ESCAPE);
        assertThat(desk.said().answers()).doesNotContainKey("region");
        assertThat(Gui.on(() -> shown().view().regionProperty().get())).isEmpty();
    }

    /** What is on its way is neither remembered nor written, and Escape leaves what was before: here, nothing. */
    @Test
    void aRectangleThatIsGivenUpOnItsWayIsNotRendered() {
        gui.act(pane::render);
        untilDone();
        gui.click("#render-region-drag-toggle");
        Node view = shown().view();
        double middle = view.getLayoutBounds().getWidth() / 2;
        gui.moveTo(view, middle - 40, 100);
        gui.press(MouseButton.PRIMARY);
        gui.moveTo(view, middle, 130);
        gui.moveTo(view, middle + 40, 160);
        assertThat(Gui.on(() -> shown().view().regionProperty().get())).as("it is drawn").isPresent();
        assertThat(desk.said().answers()).isEmpty();
        gui.keys(KeyCode.ESCAPE);
        Node picture = shown().view().getChildrenUnmodifiable().get(1);
        double left = picture.getLayoutX();
        gui.moveTo(view, middle + 60, 180);
        assertThat(picture.getLayoutX()).as("the picture stays").isEqualTo(left);
        gui.release(MouseButton.PRIMARY);
        assertThat(Gui.on(() -> shown().view().regionProperty().get())).isEmpty();
        assertThat(desk.said().answers()).isEmpty();
        assertThat(gui.stage().getScene().lookup("#render-region-clear").isVisible()).isFalse();
    }

    @Test
    void aFormThatIsBeingFilledInIsNotOverwritten() {
        gui.click("#render-ask");
        enter("#render-width", "77");
        gui.act(pane::render);
        gui.act(pane::ask);
        assertThat(tabs().getTabs()).as("the answer is waited for").isEmpty();
        gui.act(() -> pane.goOn(left(Map.of("size", "30x20"))));
        gui.until("what was left is done", () -> task(0).getState() == Worker.State.SUCCEEDED);
        assertThat(shown().getText()).isEqualTo("1: ball · 30 × 20");
        gui.act(() -> pane.goOn(left(Map.of("depth", "0"))));
        assertThat(tabs().getTabs()).hasSize(1);
        assertThat(label("#render-message")).startsWith("The unfinished picture is kept");
        assertThat(gui.node("#render-dialog").isVisible()).isTrue();
        assertThat(((TextField) gui.node("#render-width")).getText()).isEqualTo("77");
    }

    private static UnfinishedPictures.Resumed left(Map<String, String> answers) {
        return new UnfinishedPictures.Resumed(UnfinishedPictures.notKept().begin(SCENE, Map.of()), SCENE, Assets.none(), answers);
    }

    /** Of one pass, and of passes of paths with what else is kept of each pixel. */
    @ParameterizedTest
    @ValueSource(strings = {"", "denoise", "mix"})
    void whatWasCancelledGoesOnToTheSameBytes(String how) {
        RenderSettings settings = how.isEmpty() ? new RenderSettings(400, 300, 5, 3) : PATHS.withSize(64, 48).withSamples(384);
        if (how.length() > 0) {
            desk.said().put(how, "true");
        }
        AtomicReference<Optional<RenderTask>> held = new AtomicReference<>(Optional.empty());
        Gate gate = new Gate(() -> Objects.requireNonNull(held.get()).map(task -> !task.isCancelled() && task.progress().share() > 0.4).orElse(true));
        gui.act(() -> model.edit(CHANGE, scene -> SCENE.withSettings(settings).plus(SceneObject.of(gate))));
        gui.act(pane::render);
        RenderTask first = shown().task();
        held.set(Optional.of(first));
        gui.until("some tiles are done", () -> first.progress().share() > 0.3);
        gui.click("#render-cancel");
        gui.until("the workers have stopped", first::isStopped);
        assertThat(first.progress().done()).isLessThan(first.progress().total());
        gui.click("#render-go-on");
        untilDone();
        RenderOptions options = RenderOptions.of(settings);
        RenderOptions wished = how.equals("denoise") ? options.withDenoiser() : how.equals("mix") ? options.withLayers(List.of(Layer.LIGHT)) : options;
        RenderResult whole = Renderer.render(RenderScene.of(model.scene()), wished, RenderMonitor.NONE);
        assertThat(shown().task()).isNotSameAs(first);
        assertThat(shown().task().options()).isEqualTo(wished);
        assertThat(shown().task().image().orElseThrow().toLinear()).isEqualTo(whole.image().toLinear());
        assertThat(Gui.on(() -> shown().task().getValue().layers())).usingRecursiveComparison().isEqualTo(whole.layers());
        assertThat(Gui.on(() -> shown().task().getValue().stats().rays())).as("only what was left was traced").isLessThan(whole.stats().rays());
        assertThat(shown().task().progress().share()).isEqualTo(1);
    }

    @Test
    void theDifferenceOfTwoPicturesHasAFigureAndAMap() {
        gui.act(pane::render);
        untilDone();
        gui.act(() -> model.edit(CHANGE, scene -> scene.withLights(List.of(Light.at(3, 5, 5)))));
        gui.act(pane::render);
        untilDone();
        gui.act(() -> gui.stage().getScene().lookup("#render-compare").requestFocus());
        gui.keys(KeyCode.DOWN);
        gui.until("it is compared", () -> ((Label) shown().getContent().lookup("#render-difference-figures")).getText().startsWith("Steps of 1/255"));
        Image a = Renderer.render(model.scene());
        Image b = Renderer.render(SCENE);
        int largest = IntStream.range(0, 120 * 80).flatMap(i -> IntStream.of(0, 8, 16)
                .map(shift -> Math.abs((a.argb(i % 120, i / 120) >> shift & 255) - (b.argb(i % 120, i / 120) >> shift & 255)))).max().orElseThrow();
        assertThat(label("#render-difference-figures")).contains("largest " + largest + " at ");
        assertThat(Gui.on(() -> shown().view().lookupAll(".side-name").stream().map(node -> ((Label) node).getText()).toList()))
                .containsExactly("A  2: ball · 120 × 80", "B  1: ball · 120 × 80");
        gui.act(() -> ((ToggleButton) gui.node("#render-difference")).setSelected(true));
        assertThat(Gui.on(() -> ((Label) shown().view().lookupAll(".side-name").toArray()[1]).getText())).isEqualTo("Difference of A and B");
        assertThat(Screenshots.save(gui, "render-difference")).isNotEmptyFile();
    }

    @Test
    void theMouseReadsDepthsAndCountsAndNotTheirColours() {
        desk.said().put("mode", "depth");
        gui.act(pane::render);
        untilDone();
        gui.moveTo(shown().view(), shown().view().getWidth() / 2 + 1, shown().view().getHeight() / 2 + 1);
        double depth = Renderer.render(RenderScene.of(SCENE), RenderOptions.of(SCENE).withMode(RenderMode.DEPTH).withNumbers(), RenderMonitor.NONE).image().red(60, 40);
        assertThat(depth).isBetween(4.999, 5.01);
        gui.until("the depth is told", () -> text("#pixel-text").contains(String.format(Locale.ROOT, "distance %.4f ", depth)));
        desk.said().put("mode", "rays");
        gui.act(pane::render);
        untilDone();
        gui.moveTo(shown().view(), shown().view().getWidth() / 2 + 2, shown().view().getHeight() / 2 + 1);
        gui.until("the count is told", () -> text("#pixel-text").contains(" 2 rays "));
    }

    @Test
    void whatIsEnlargedIsNotBlurred() {
        gui.act(pane::render);
        untilDone();
        gui.click("#render-actual");
        gui.act(() -> shown().view().requestFocus());
        for (int i = 0; i < 6; i++) {
            gui.keys(KeyCode.ADD);
        }
        assertThat(Gui.on(() -> Math.rint(1e6 * shown().view().zoomProperty().get()) / 1e6)).isEqualTo(8);
        Image expected = Renderer.render(SCENE);
        double left = Gui.on(() -> Math.rint((shown().view().getWidth() - 120) / 2));
        double x = Gui.on(() -> shown().view().getWidth() / 2);
        WritableImage seen = Gui.on(() -> shown().view().snapshot(null, null));
        // The middle stays where it is; 8 points of the screen are one pixel.
        for (int point = -200; point < 200; point += 3) {
            int column = (int) Math.floor((x - left) + (point + 0.5) / 8);
            double y = Gui.on(() -> shown().view().getHeight() / 2);
            int row = (int) Math.floor(y - Gui.on(() -> Math.rint((shown().view().getHeight() - 80) / 2)) + 0.5 / 8);
            assertThat(seen.getPixelReader().getArgb((int) x + point, (int) y)).as("%d", point).isEqualTo(expected.argb(column, row));
        }
    }

    private void enter(String field, String text) {
        gui.click(field);
        gui.act(() -> ((TextField) gui.stage().getScene().lookup(field)).setText(text));
    }

    private void untilDone() {
        gui.until("the picture is done", () -> shown().task().getState() == Worker.State.SUCCEEDED);
    }

    private RenderTask task(int tab) {
        return ((RenderTab) tabs().getTabs().get(tab)).task();
    }

    private RenderTab shown() {
        return (RenderTab) tabs().getSelectionModel().getSelectedItem();
    }

    private TabPane tabs() {
        return (TabPane) pane.lookup("#renders");
    }

    private String label(String selector) {
        return Gui.on(() -> text(selector));
    }

    /** For JavaFX's thread. */
    private String text(String selector) {
        return ((Label) (shown() != null && shown().getContent().lookup(selector) != null ? shown().getContent() : pane).lookup(selector)).getText();
    }
}
