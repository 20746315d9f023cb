package cz.paprsek.fx.view.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.picture.UnfinishedPictures;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.picture.PictureView;
import cz.paprsek.fx.view.render.fields.Remembered;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Sphere;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import javafx.beans.property.SimpleObjectProperty;
import javafx.concurrent.Worker;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.TabPane;
import javafx.scene.input.Clipboard;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** How rendered pictures are looked at: by mouse, beside others, in another language. */
class RenderLooksTest {
    private static final Scene SCENE = Scene.EMPTY.withName("ball/1").withSettings(new RenderSettings(120, 80, 5, 1))
            .withCamera(Camera.lookingAt(new Vec3(0, 0, 6), Vec3.ZERO)).plus(Light.at(3, 5, 6))
            .plus(SceneObject.of(new Sphere(1)).named("ball").madeOf(Material.color(200, 60, 40)));

    private static final cz.paprsek.fx.model.Label CHANGE = cz.paprsek.fx.model.Label.of(cz.paprsek.fx.model.Label.Edit.CHANGE);

    private final EditorModel model = new EditorModel(SCENE);
    private final RenderPane pane = Gui.on(() -> pane(Locale.ENGLISH));
    private final Gui gui = Gui.show(() -> pane, 900, 600);

    private RenderPane pane(Locale language) {
        return new RenderPane(model, new RenderDesk(Remembered.forNow(), UnfinishedPictures.notKept()), Texts.in(language), new SimpleObjectProperty<>(Theme.LIGHT),
                (owner, name) -> Optional.empty(), (owner, name) -> Optional.empty());
    }

    @AfterEach
    void close() {
        gui.act(pane::cancelAll);
        gui.close();
    }

    @Test
    void aPaneInAnotherLanguageTakesThePicturesOver() {
        gui.act(pane::render);
        untilDone();
        RenderPane czech = Gui.on(() -> pane(Locale.forLanguageTag("cs")));
        gui.act(() -> {
            czech.takeOver(pane);
            gui.stage().getScene().setRoot(czech);
        });
        assertThat(Gui.on(() -> czech.statusProperty().get())).startsWith("Hotovo");
        RenderTab taken = (RenderTab) ((TabPane) gui.node("#renders")).getTabs().get(0);
        assertThat(taken.task()).isSameAs(shown().task());
    }

    @Test
    void copiesThePicture() {
        gui.act(pane::render);
        untilDone();
        gui.click("#render-copy");
        javafx.scene.image.Image copied = Gui.on(() -> Clipboard.getSystemClipboard().getImage());
        assertThat(copied.getPixelReader().getArgb(60, 40)).isEqualTo(Renderer.render(SCENE).argb(60, 40));
    }

    @Test
    void theMouseReadsOutPixelsAndTellsOfClicks() {
        gui.act(pane::render);
        untilDone();
        AtomicReference<Optional<PicturePoint>> pointed = new AtomicReference<>(Optional.empty());
        AtomicReference<Optional<PicturePoint>> clicked = new AtomicReference<>(Optional.empty());
        gui.act(() -> {
            pane.setOnPointed(pointed::set);
            pane.setOnClicked(point -> clicked.set(Optional.of(point)));
        });
        Node view = gui.node(".picture-view");
        gui.click(view, view.getLayoutBounds().getWidth() / 2 + 2, view.getLayoutBounds().getHeight() / 2 + 2);
        Image image = Renderer.render(SCENE);
        String text = label("#pixel-text");
        assertThat(text).startsWith("60, 40").endsWith("ball").contains("linear " + String.format(Locale.ROOT, "%.4f", image.red(60, 40)));
        assertThat(clicked.get()).isPresent().isEqualTo(pointed.get());
        gui.moveTo(view, 1, 1);
        assertThat(label("#pixel-text")).isEmpty();
    }

    @Test
    void theWheelZoomsAboutTheMouse() {
        gui.act(pane::render);
        untilDone();
        Node view = gui.node(".picture-view");
        gui.moveTo(view, 300, 200);
        String before = label("#pixel-text");
        double zoom = shown().view().zoomProperty().get();
        gui.wheel(3);
        assertThat(shown().view().zoomProperty().get()).isNotEqualTo(zoom);
        gui.moveTo(view, 300.4, 200);
        assertThat(label("#pixel-text")).isEqualTo(before);
        gui.click("#render-actual");
        assertThat(shown().view().zoomProperty().get()).isEqualTo(1);
        gui.click("#render-fit");
        assertThat(shown().view().zoomProperty().get()).isEqualTo(zoom);
    }

    @Test
    void earlierRendersAreKeptAndComparedWithAWipe() {
        gui.act(pane::render);
        untilDone();
        gui.act(() -> model.edit(CHANGE, scene -> scene.withBackground(Rgb.WHITE).withName("White")));
        gui.act(pane::render);
        untilDone();
        assertThat(tabs().getTabs()).hasSize(2);
        assertThat(shown().getText()).startsWith("2: White · ");
        gui.act(() -> gui.stage().getScene().lookup("#render-compare").requestFocus());
        gui.keys(KeyCode.DOWN);
        Node wipe = gui.node(".wipe");
        double x = wipe.getBoundsInParent().getCenterX();
        assertThat(colorAt(x - 40)).isEqualTo(0xFFFFFFFF);
        assertThat(colorAt(x + 40)).isEqualTo(0xFF000000);
        gui.drag(shown().view(), x, 20, x - 100, 20);
        assertThat(wipe.getBoundsInParent().getCenterX()).isBetween(x - 102, x - 98);
        assertThat(colorAt(x - 40)).isEqualTo(0xFF000000);
        gui.act(() -> tabs().getTabs().remove(0));
        assertThat(gui.stage().getScene().getRoot().lookup(".wipe").isVisible()).isFalse();
    }

    /** What is shown in an upper row of the picture, where only the background is seen. */
    private int colorAt(double x) {
        return Gui.on(() -> {
            PictureView view = shown().view();
            return view.snapshot(null, null).getPixelReader().getArgb((int) x, (int) view.getHeight() / 2 - 150);
        });
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

    private String label(String selector) {
        return Gui.on(() -> ((Label) pane.lookup(selector)).getText());
    }
}
