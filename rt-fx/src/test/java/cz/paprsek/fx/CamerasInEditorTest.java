package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.item.Item;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Scene;
import java.nio.file.Path;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.input.KeyCode;
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
        editor.gui.act(() -> editor.model().select(Item.CAMERA));
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
        assertThat(Screenshots.save(editor.gui, "camera-focus")).isNotEmptyFile();
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().scene().camera().lens()).isEqualTo(Lens.Perspective.DEFAULT.withFovy(25));
    }

    @Test
    void camerasAreAddedChangedAndSwitched() {
        editor.menu("view-menu-new-camera");
        assertThat(editor.model().scene().cameras()).extracting(Camera::name).containsExactly("camera 2", "camera");
        assertThat(editor.model().selection()).containsExactly(Item.CAMERA);
        ComboBox<Class<?>> projection = choice();
        editor.gui.act(() -> projection.setValue(Lens.Orthographic.class));
        assertThat(editor.model().scene().camera().lens()).isInstanceOf(Lens.Orthographic.class);
        assertThat(editor.gui.node("#lens-height").isVisible()).isTrue();
        assertThat(editor.gui.stage().getScene().lookup("#lens-fovy")).as("only what the projection has").isNull();
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
        assertThat(Screenshots.save(editor.gui, "camera-orthographic")).isNotEmptyFile();
        editor.menu("view-menu-next-camera");
        assertThat(editor.model().scene().camera()).matches(camera -> camera.name().equals("camera") && camera.lens() instanceof Lens.Perspective);
        editor.menu("view-menu-next-camera");
        editor.menu("view-menu-remove-camera");
        assertThat(editor.model().scene().cameras()).extracting(Camera::name).containsExactly("camera");
    }

    @SuppressWarnings("unchecked") // The sheet has kinds of lenses there.
    private ComboBox<Class<?>> choice() {
        return (ComboBox<Class<?>>) editor.gui.node("#lens");
    }
}
