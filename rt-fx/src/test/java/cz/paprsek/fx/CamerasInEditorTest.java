package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.view.camera.CameraPane;
import cz.paprsek.fx.view.projection.ProjectionPane;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.SphereLight;
import java.nio.file.Path;
import java.util.Locale;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import javafx.stage.Window;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Several cameras and their lenses, by menu, sheet and mouse. */
class CamerasInEditorTest {
    @TempDir
    Path folder;

    private EditorGui editor;

    @BeforeEach
    void open() {
        Scene scene = Templates.read("showcase");
        editor = new EditorGui(folder, scene.withSettings(scene.settings().withSamples(1))
                .withCamera(Camera.lookingAt(scene.camera().position(), new Vec3(0.55, 0.5, 1)).withFovy(25)));
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
    }

    @AfterEach
    void close() {
        editor.close();
    }

    @Test
    void whatIsClickedIsSharp() {
        editor.menu("view-menu-focus");
        assertThat(editor.status()).contains("what shall be sharp");
        Node picture = editor.gui.node(".live-picture");
        Bounds frame = editor.gui.node(".picture-frame").getBoundsInParent();
        editor.gui.click(picture, frame.getMinX() + 0.5 * frame.getWidth(), frame.getMinY() + 0.5 * frame.getHeight());
        Lens.Perspective lens = (Lens.Perspective) editor.model().scene().camera().lens();
        assertThat(lens.aperture()).isPositive();
        assertThat(lens.focus()).isBetween(4.0, 8.0);
        assertThat(editor.model().selection()).as("nothing is selected by this click").isEmpty();
        editor.gui.act(() -> editor.model().select(ScenePath.camera()));
        assertThat(Screenshots.save(editor.gui, "camera-focus")).isNotEmptyFile();
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().scene().camera().lens()).isEqualTo(Lens.Perspective.DEFAULT.withFovy(25));
    }

    @Test
    void whatTheMouseIsAskedForEndsByEscapeAnywhereByWhoAsksNextAndWithTheScene() {
        Scene before = editor.model().scene();
        Node picture = editor.gui.node(".live-picture");
        Bounds frame = editor.gui.node(".picture-frame").getBoundsInParent();
        editor.menu("view-menu-focus");
        editor.gui.act(() -> editor.gui.node("#tree-list").requestFocus());
        editor.gui.keys(KeyCode.ESCAPE);
        assertThat(editor.status()).as("what was asked").isEmpty();
        editor.menu("view-menu-focus");
        editor.gui.act(() -> editor.editor.say("Newer."));
        editor.gui.keys(KeyCode.ESCAPE);
        assertThat(editor.status()).isEqualTo("Newer.");
        editor.menu("view-menu-focus");
        editor.gui.act(picture::requestFocus);
        editor.gui.keys(KeyCode.B);
        editor.gui.drag(picture, frame.getMinX() + 2, frame.getMinY() + 2, frame.getMaxX() - 2, frame.getMaxY() - 2);
        assertThat(editor.model().selection()).as("in the rubber band").isNotEmpty();
        assertThat(editor.model().scene()).as("nothing made sharp, nothing turned").isSameAs(before);
        editor.gui.act(picture::requestFocus);
        editor.gui.keys(KeyCode.B);
        editor.menu("view-menu-focus");
        editor.menu("render-menu-region");
        editor.menu("template-studio");
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
        Scene opened = editor.model().scene();
        Bounds inside = editor.gui.node(".picture-frame").getBoundsInParent();
        editor.gui.click(picture, inside.getCenterX(), inside.getCenterY());
        assertThat(editor.model().selection()).as("a click selects").isNotEmpty();
        editor.gui.drag(picture, inside.getMinX() + 5, inside.getMinY() + 5, inside.getMinX() + 60, inside.getMinY() + 40);
        assertThat(editor.editor.renders().framing().getValue().part()).as("no part is drawn").isEmpty();
        assertThat(editor.model().scene().camera().lens()).as("nothing is made sharp").isEqualTo(opened.camera().lens());
    }

    @Test
    void theFirstPictureWithSoftEdgesShadowsAndBackgroundTakesFourClicks() {
        editor.menu("template-studio");
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
        editor.gui.click("#object-soften-button");
        editor.gui.click("#view-menu-focus-button");
        Node picture = editor.gui.node(".live-picture");
        Bounds frame = editor.gui.node(".picture-frame").getBoundsInParent();
        editor.gui.click(picture, frame.getMinX() + 0.5 * frame.getWidth(), frame.getMinY() + 0.5 * frame.getHeight());
        Scene scene = editor.model().scene();
        assertThat(scene.settings().mostRays()).as("smooth edges").isGreaterThan(16);
        assertThat(scene.lights()).as("soft shadows").allMatch(SphereLight.class::isInstance);
        assertThat(((Lens.Perspective) scene.camera().lens()).aperture()).as("a blurred background").isPositive();
        editor.gui.click("#render-menu-render-button");
        assertThat(Gui.on(() -> Window.getWindows().stream().anyMatch(window -> window instanceof Stage stage && stage.getTitle().toLowerCase(Locale.ROOT).contains("pictures")))).isTrue();
    }

    @Test
    void camerasAreAddedChangedAndSwitched() {
        editor.menu("view-menu-new-camera");
        assertThat(editor.model().scene().cameras()).extracting(Camera::name).containsExactly("camera", "camera 2");
        assertThat(editor.model().selection()).containsExactly(ScenePath.camera(1));
        ComboBox<Class<?>> projection = choice();
        editor.gui.act(() -> projection.setValue(Lens.Orthographic.class));
        assertThat(editor.model().state().camera().lens()).isInstanceOf(Lens.Orthographic.class);
        assertThat(editor.gui.node("#lens-height").isVisible()).isTrue();
        assertThat(editor.gui.stage().getScene().lookup("#lens-fovy")).as("only what the projection has").isNull();
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
        assertThat(Screenshots.save(editor.gui, "camera-orthographic")).isNotEmptyFile();
        Scene before = editor.model().scene();
        editor.menu("view-menu-next-camera");
        assertThat(editor.model().state().camera()).isEqualTo(before.camera());
        assertThat(editor.model().scene()).as("looking changes nothing").isSameAs(before);
        editor.menu("view-menu-next-camera");
        editor.menu("view-menu-first-camera");
        assertThat(editor.model().scene().cameras()).extracting(Camera::name).containsExactly("camera 2", "camera");
        editor.menu("view-menu-remove-camera");
        assertThat(editor.model().scene().cameras()).extracting(Camera::name).containsExactly("camera");
    }

    @Test
    void theFreeViewIsMovedWithoutTheScenesCameraUntilThatIsWished() {
        Scene start = editor.model().scene();
        editor.gui.keys(KeyCode.CONTROL, KeyCode.DIGIT5);
        CameraPane free = (CameraPane) editor.gui.node("#free-pane");
        Node picture = editor.gui.node("#free-pane .live-picture");
        editor.gui.until("the picture is complete", free::isComplete);
        assertThat(free.camera()).isEqualTo(start.camera());
        editor.gui.act(() -> editor.model().select());
        editor.gui.drag(picture, 20, 20, 90, 40);
        assertThat(free.camera()).isNotEqualTo(start.camera());
        assertThat(editor.model().scene()).isSameAs(start);
        editor.menu("free-top");
        assertThat(free.camera().forward().y()).isCloseTo(-1, Offset.offset(1e-5));
        assertThat(free.camera().position().y()).isGreaterThan(4);
        editor.menu("free-from-camera");
        assertThat(free.camera()).isEqualTo(start.camera());
        editor.menu("free-right");
        editor.gui.act(() -> editor.model().select(ScenePath.body(0)));
        editor.menu("free-selection");
        editor.gui.act(picture::requestFocus);
        editor.gui.keys(KeyCode.G);
        editor.gui.keys(KeyCode.Z);
        editor.gui.keys(KeyCode.DIGIT1);
        editor.gui.keys(KeyCode.ENTER);
        assertThat(editor.model().scene().objects().get(0).placement().position()).as("edited here, too").isEqualTo(start.objects().get(0).placement().position().plus(new Vec3(0, 0, 1)));
        editor.gui.until("the picture is complete", free::isComplete);
        assertThat(Screenshots.save(editor.gui, "free-view")).isNotEmptyFile();
        editor.menu("free-to-camera");
        assertThat(editor.model().scene().camera().position()).isEqualTo(free.camera().position());
        editor.gui.act(editor.model()::undo);
        assertThat(editor.model().scene().camera()).isEqualTo(start.camera());
        editor.menu("cut-x");
        Node cut = editor.gui.node("#free-pane .cut-slider");
        editor.gui.act(() -> editor.model().open(start.withCamera(start.camera().withPosition(new Vec3(0, 1, 9)))));
        assertThat(free.camera()).as("of the scene opened now").isEqualTo(editor.model().scene().camera());
        assertThat(cut.getParent().isVisible()).as("whole").isFalse();
        editor.menu("view-menu-right");
        assertThat(editor.gui.node("#projection-right")).as("the view from the right is back").isNotNull();
    }

    @Test
    void theTitleOfThePictureChoosesTheCamera() {
        editor.menu("view-menu-new-camera");
        MenuButton chooser = (MenuButton) editor.gui.node("#camera-chooser");
        assertThat(Gui.on(chooser::getText)).isEqualTo("camera 2");
        editor.gui.click(chooser);
        editor.gui.until("the list is open", chooser::isShowing);
        assertThat(Gui.on(() -> chooser.getItems().stream().limit(2).map(MenuItem::getText).toList())).containsExactly("camera", "camera 2");
        editor.gui.keys(KeyCode.ESCAPE);
        editor.gui.act(() -> chooser.getItems().get(0).fire());
        assertThat(editor.model().state().eye()).isZero();
        editor.gui.keys(KeyCode.CONTROL, KeyCode.ALT, KeyCode.K);
        assertThat(editor.model().state().eye()).as("the key works beside the list").isEqualTo(1);
    }

    @Test
    void camerasAreNamedCopiedAndDeletedInTheTree() {
        editor.gui.act(() -> editor.model().select(ScenePath.camera()));
        editor.gui.act(() -> editor.gui.node("#tree-list").requestFocus());
        editor.gui.keys(KeyCode.F2);
        TextInputControl field = (TextInputControl) editor.gui.node("#tree-rename");
        editor.gui.act(() -> field.setText("left"));
        editor.gui.keys(KeyCode.ENTER);
        assertThat(editor.model().scene().camera().name()).isEqualTo("left");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.D);
        assertThat(editor.model().scene().cameras()).extracting(Camera::name).containsExactly("left", "left 2");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.C);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.V);
        assertThat(editor.model().scene().cameras()).extracting(Camera::name).containsExactly("left", "left 2", "left 3");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        editor.menu("object-look");
        assertThat(editor.model().state().eye()).isEqualTo(1);
        editor.gui.keys(KeyCode.DELETE);
        assertThat(editor.model().scene().cameras()).extracting(Camera::name).containsExactly("left");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().scene().cameras()).hasSize(2);
        assertThat(editor.model().state().eye()).isEqualTo(1);
    }

    @Test
    void everyCameraIsDrawnAndDraggedByItsAim() {
        editor.menu("view-menu-new-camera");
        editor.menu("view-menu-next-camera");
        ProjectionPane top = editor.projection("top");
        Camera second = editor.model().scene().cameras().get(1);
        Vec3 target = ((Camera.Target) second.aim()).point();
        Point2D from = EditorGui.place(top, target.x(), target.y(), target.z());
        Point2D to = EditorGui.place(top, target.x() + 1, target.y(), target.z());
        editor.gui.drag(top, from.getX(), from.getY(), to.getX(), to.getY());
        assertThat(((Camera.Target) editor.model().scene().cameras().get(1).aim()).point().x()).isGreaterThan(target.x());
        assertThat(editor.model().scene().camera().aim()).as("the other stays").isEqualTo(second.aim());
    }

    @SuppressWarnings("unchecked") // The sheet has kinds of lenses there.
    private ComboBox<Class<?>> choice() {
        return (ComboBox<Class<?>>) editor.gui.node("#lens");
    }
}
