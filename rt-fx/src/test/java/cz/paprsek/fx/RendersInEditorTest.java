package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javafx.geometry.Point2D;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Labeled;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.shape.Rectangle;
import javafx.stage.Stage;
import javafx.stage.Window;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Renders asked for in the editor by keys, from one start to the next. */
class RendersInEditorTest {
    @TempDir
    private Path folder = Path.of("");

    @Test
    void howToRenderIsAskedForByKeysAndRememberedForTheNextStartInAnyLanguage() throws IOException {
        Scene scene = Scene.EMPTY.withName("empty").withSettings(new RenderSettings(64, 48, 3, 1));
        try (EditorGui editor = new EditorGui(folder, scene)) {
            press(editor, KeyCode.R);
            editor.gui.until("it is asked", () -> pictures().lookup("#render-dialog").isVisible());
            assertThat(Gui.on(() -> pictures().getScene().getFill())).as("what is seen before the first paint").isEqualTo(Theme.LIGHT.palette().background());
            editor.gui.act(() -> ((TextField) pictures().lookup("#render-width")).setText("32"));
            editor.gui.keys(KeyCode.ENTER);
            editor.gui.until("it is rendered", () -> status(editor).startsWith("Done in"));
            editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
            editor.gui.until("it is told in Czech", () -> status(editor).startsWith("Hotovo za"));
            assertThat(Gui.on(() -> tabs().getTabs().get(0).getText())).isEqualTo("1: empty · 32 × 48");
        }
        assertThat(Files.readString(folder.resolve("editor.properties"))).contains("render=size\\=32x48");
        try (EditorGui editor = new EditorGui(folder, scene)) {
            editor.menu("render-menu-render");
            editor.gui.until("it is rendered as was said before", () -> tabs().getTabs().size() == 1 && tabs().getTabs().get(0).getText().equals("1: empty · 32 × 48"));
        }
    }

    /** One is damaged, one discarded, and one goes on. */
    @Test
    void whatAnEarlierProcessLeftIsOfferedOneAfterTheOther() throws IOException {
        Scene scene = Scene.EMPTY.withName("left").withSettings(new RenderSettings(64, 48, 3, 1));
        for (String number : List.of("1", "2", "3")) {
            Path room = Files.createDirectories(folder.resolve("pictures/00000000-0000-4000-8000-00000000000" + number));
            SceneFiles.write(scene, room.resolve("scene.xml"));
            Files.writeString(room.resolve("picture.properties"), number.equals("1") ? "source=\\u00zz" : "answer.size=32x24\nname=left");
        }
        try (EditorGui editor = new EditorGui(folder, Scene.EMPTY)) {
            editor.gui.until("the first is offered", () -> isOffered(editor));
            editor.gui.click("#recovery-go-on");
            editor.gui.until("it is told what is the matter with it", () -> editor.status().endsWith("picture.properties: is damaged"));
            editor.gui.until("the next is offered", () -> isOffered(editor));
            assertThat(editor.text("#message")).isEqualTo("There is an unfinished picture of left from a session that ended before it was done.");
            editor.gui.click("#recovery-discard");
            editor.gui.until("the last is offered", () -> isOffered(editor));
            editor.gui.click("#recovery-go-on");
            editor.gui.until("it is rendered", () -> status(editor).startsWith("Done in"));
            assertThat(Gui.on(() -> tabs().getTabs().get(0).getText())).isEqualTo("1: left · 32 × 24");
            assertThat(folder.resolve("pictures").toFile().list()).containsExactly("00000000-0000-4000-8000-000000000001");
        }
    }

    @Test
    void aPartOfTheCamerasPictureIsDrawnByMouseAndByKeys() throws IOException {
        Scene scene = Scene.EMPTY.withName("part").withSettings(new RenderSettings(64, 48, 3, 1));
        try (EditorGui editor = new EditorGui(folder, scene)) {
            Node picture = editor.gui.node(".live-picture");
            Rectangle frame = (Rectangle) editor.gui.node(".picture-frame");
            double pixel = Gui.on(() -> frame.getWidth() / 64);
            editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.N);
            editor.gui.moveTo(picture, frame.getX() + 8.5 * pixel, frame.getY() + 4.5 * pixel);
            editor.gui.press(MouseButton.PRIMARY);
            editor.gui.moveTo(picture, frame.getX() + 23.5 * pixel, frame.getY() + 11.5 * pixel);
            editor.gui.keys(KeyCode.ENTER);
            editor.gui.moveTo(picture, frame.getX() + 20.5 * pixel, frame.getY() + 20.5 * pixel);
            editor.gui.release(MouseButton.PRIMARY);
            assertThat(editor.status()).as("Enter ends a drag").startsWith("Rendered alone from now on: 8, 4 · 16 × 8;");
            assertThat(editor.model().scene()).isEqualTo(scene);
            editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.N);
            assertThat(editor.status()).startsWith("Drag over the camera");
            editor.gui.drag(picture, frame.getX() + 8.5 * pixel, frame.getY() + 4.5 * pixel, frame.getX() + 39.5 * pixel, frame.getY() + 27.5 * pixel);
            assertThat(editor.text("#camera-pane .region-numbers")).isEqualTo("8, 4 · 32 × 24");
            assertThat(editor.status()).startsWith("Rendered alone from now on: 8, 4 · 32 × 24;");
            assertThat(editor.model().scene()).as("the camera has not been moved by it").isEqualTo(scene);
            press(editor, KeyCode.R);
            editor.gui.until("it is asked", () -> pictures().lookup("#render-dialog").isVisible());
            assertThat(Gui.on(() -> List.of(field("#render-region-x"), field("#render-region-y"), field("#render-region-width"), field("#render-region-height")))).containsExactly("8", "4", "32", "24");
            editor.gui.act(() -> editor.gui.stage().requestFocus());
            editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.N);
            editor.gui.keys(KeyCode.RIGHT);
            editor.gui.keys(KeyCode.SHIFT, KeyCode.DOWN);
            editor.gui.keys(KeyCode.ALT, KeyCode.LEFT);
            editor.gui.keys(KeyCode.ENTER);
            assertThat(editor.text("#camera-pane .region-numbers")).isEqualTo("9, 14 · 31 × 24");
            assertThat(Gui.on(() -> field("#render-region-x"))).as("what is asked meanwhile follows").isEqualTo("9");
            assertThat(editor.status()).startsWith("Rendered alone from now on: 9, 14 · 31 × 24;");
            editor.gui.act(() -> ((Button) pictures().lookup("#render-start")).fire());
            editor.gui.until("it is rendered", () -> status(editor).startsWith("Done in"));
            assertThat(Gui.on(() -> tabs().getTabs().get(0).getText())).isEqualTo("1: part · 64 × 48 · part 9, 14 · 31 × 24");
            editor.gui.act(() -> editor.gui.stage().requestFocus());
            editor.gui.act(picture::requestFocus);
            editor.gui.keys(KeyCode.ESCAPE);
            assertThat(editor.status()).isEmpty();
            assertThat(Gui.on(() -> editor.gui.stage().getScene().lookup("#camera-pane .region-band").getParent().isVisible())).isFalse();
            assertThat(Gui.on(() -> pictures().lookup("#render-region-clear").isVisible())).isFalse();
            editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.N);
            editor.gui.keys(KeyCode.RIGHT);
            editor.gui.keys(KeyCode.ENTER);
            editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.CAMERA), old -> old.withSettings(new RenderSettings(48, 48, 3, 1))));
            assertThat(editor.status()).as("a part of one size is none of another").isEmpty();
            assertThat(Gui.on(() -> pictures().lookup("#render-region-clear").isVisible())).isFalse();
            editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.N);
            editor.gui.keys(KeyCode.RIGHT);
            editor.gui.keys(KeyCode.ENTER);
            editor.gui.act(() -> editor.editor.say("something else"));
            press(editor, KeyCode.R);
            editor.gui.act(() -> ((CheckBox) pictures().lookup("#render-region")).setSelected(false));
            editor.gui.act(() -> ((Button) pictures().lookup("#render-start")).fire());
            assertThat(editor.status()).as("what was said of other things stays").isEqualTo("something else");
        }
        assertThat(Files.readString(folder.resolve("editor.properties"))).doesNotContain("region");
    }

    /** The pipette, the part to be drawn and what shall be sharp: who asks last has the mouse, and nobody else believes to have it. */
    @Test
    void whoAsksForTheMouseNextHasItAlone() {
        SceneObject gold = SceneObject.of(new Sphere(1)).named("gold").madeOf(Material.DEFAULT.withReflection(0.5));
        Scene scene = Scene.EMPTY.withName("asked").withSettings(new RenderSettings(64, 48, 3, 1)).withCamera(Camera.lookingAt(new Vec3(0, 0, 6), Vec3.ZERO))
                .plus(gold).plus(SceneObject.of(new Sphere(0.2)).named("grey").at(0, -4, 0));
        try (EditorGui editor = new EditorGui(folder, scene)) {
            Node picture = editor.gui.node(".live-picture");
            Rectangle frame = (Rectangle) editor.gui.node(".picture-frame");
            double pixel = Gui.on(() -> frame.getWidth() / 64);
            editor.gui.act(() -> editor.model().select(ScenePath.body(1)));
            editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.P);
            editor.gui.until("the pipette waits", () -> editor.status().contains("material"));
            editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.N);
            assertThat(editor.status()).startsWith("Drag over the camera");
            editor.gui.drag(picture, frame.getX() + 8.5 * pixel, frame.getY() + 4.5 * pixel, frame.getX() + 39.5 * pixel, frame.getY() + 27.5 * pixel);
            assertThat(editor.status()).startsWith("Rendered alone from now on: 8, 4 · 32 × 24;");
            Point2D top = EditorGui.place(editor.projection("front"), 0, 1, 0);
            editor.gui.click(editor.projection("front"), top.getX(), top.getY());
            assertThat(editor.model().selection()).as("an ordinary click").containsExactly(ScenePath.body(0));
            assertThat(editor.model().scene()).as("nothing takes what the other is made of").isEqualTo(scene);

            editor.gui.act(() -> editor.model().select(ScenePath.body(1)));
            editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.N);
            editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.P);
            assertThat(Gui.on(picture::getCursor)).isEqualTo(Cursor.CROSSHAIR);
            editor.gui.click(picture, frame.getX() + 32 * pixel, frame.getY() + 24 * pixel);
            assertThat(editor.text("#camera-pane .region-numbers")).as("the part is as it was").isEqualTo("8, 4 · 32 × 24");
            assertThat(editor.model().scene().objects().get(1).material()).as("within the part, too").isEqualTo(gold.material());
        }
    }

    private static void press(EditorGui editor, KeyCode key) {
        editor.gui.hold(KeyCode.CONTROL);
        editor.gui.hold(KeyCode.ALT);
        editor.gui.keys(key);
        editor.gui.letGo(KeyCode.ALT);
        editor.gui.letGo(KeyCode.CONTROL);
    }

    private static String field(String id) {
        return ((TextField) pictures().lookup(id)).getText();
    }

    private static boolean isOffered(EditorGui editor) {
        Node bar = editor.gui.stage().getScene().lookup("#message-bar");
        return bar.isVisible() && bar.lookup("#recovery-go-on") != null;
    }

    /** What the main window tells of renders; for JavaFX's thread. */
    private static String status(EditorGui editor) {
        return ((Labeled) editor.gui.stage().getScene().lookup("#status-render")).getText();
    }

    private static TabPane tabs() {
        return (TabPane) pictures().lookup("#renders");
    }

    private static Parent pictures() {
        return Window.getWindows().stream().filter(window -> window instanceof Stage && window.getScene().lookup("#render-pane") != null)
                .map(window -> window.getScene().getRoot()).findFirst().orElseThrow();
    }
}
