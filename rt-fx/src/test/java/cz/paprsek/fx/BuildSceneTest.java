package cz.paprsek.fx;

import static cz.paprsek.fx.EditorGui.place;
import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.fx.view.projection.ProjectionPane;
import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.Pattern.Checkerboard;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.Csg;
import cz.paprsek.xml.SceneFiles;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Labeled;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import javafx.stage.Window;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A whole afternoon's work: a scene built by mouse and keys, rendered, saved, opened again and rendered from the file. */
class BuildSceneTest {
    @TempDir
    Path folder;

    @Test
    void builtRenderedSavedAndReadBack() throws Exception {
        Path xml = folder.resolve("bowl.xml");
        Path png = folder.resolve("bowl.png");
        Scene start = Templates.read("plain");
        try (EditorGui editor = new EditorGui(folder, start)) {
            bowl(editor);
            glassBall(editor);
            checkeredFloor(editor);
            secondLight(editor);
            editor.gui.act(() -> editor.model().select());
            editor.gui.until("the live picture is complete", editor.editor::isPictureComplete);
            Screenshots.save(editor.gui, "built");
            Scene built = editor.model().scene();

            editor.dialogs.save = Optional.of(xml);
            editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
            assertThat(SceneFiles.read(xml)).isEqualTo(built);
            assertThat(editor.model().unsavedProperty().get()).isFalse();

            editor.dialogs.picture = Optional.of(png);
            render(editor);
            assertSame(ImageIO.read(png.toFile()), Renderer.render(SceneFiles.read(xml).withSettings(built.settings().withSize(160, 90))));

            ProjectionPane front = editor.projection("front");
            editor.gui.act(front::requestFocus);
            while (editor.model().undoableProperty().get().isPresent()) {
                editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
            }
            assertThat(editor.model().scene()).isEqualTo(start);
            while (editor.model().redoableProperty().get().isPresent()) {
                editor.gui.keys(KeyCode.CONTROL, KeyCode.Y);
            }
            assertThat(editor.model().scene()).isEqualTo(built);
            assertThat(editor.model().unsavedProperty().get()).isFalse();
            assertThat(editor.dialogs.faults).isEmpty();
        }
    }

    /** A ball without its upper half, left of the middle. */
    private static void bowl(EditorGui editor) {
        ProjectionPane front = editor.projection("front");
        editor.gui.click("#add-sphere");
        Vec3 middle = editor.model().scene().objects().get(0).placement().position();
        editor.gui.click("#add-block");
        drag(editor, front, middle, middle.plus(new Vec3(0, 1.2, 0)));
        click(editor, front, middle.plus(new Vec3(0, -0.8, 0)));
        editor.gui.hold(KeyCode.SHIFT);
        click(editor, front, middle.plus(new Vec3(0.9, 1.9, 0)));
        editor.gui.letGo(KeyCode.SHIFT);
        editor.gui.click("#object-difference-button");
        assertThat(editor.model().scene().objects()).singleElement()
                .matches(object -> object.shape() instanceof Csg csg && csg.operation() == Csg.Operation.DIFFERENCE);
        drag(editor, front, middle.plus(new Vec3(0, -0.8, 0)), middle.plus(new Vec3(-2, -0.8, 0)));
        choose(editor, "#material", 6);
    }

    /** Moved in the view from the right, so that all three views have been used. */
    private static void glassBall(EditorGui editor) {
        editor.gui.click("#add-sphere");
        Vec3 middle = editor.model().scene().objects().get(1).placement().position();
        drag(editor, editor.projection("right"), middle, middle.plus(new Vec3(0, 0, 1)));
        drag(editor, editor.projection("top"), middle.plus(new Vec3(0, 0, 1)), middle.plus(new Vec3(1, 0, 1)));
        choose(editor, "#material", 2);
        Vec3 moved = editor.model().scene().objects().get(1).placement().position();
        assertThat(moved).matches(at -> at.x() > 0.5 && at.y() == middle.y() && at.z() > 0.5);
        assertThat(editor.model().scene().objects().get(1).material()).isEqualTo(new MaterialName("glass"));
    }

    /** A rectangle laid down by its handle, made large by another and put below the rest. */
    private static void checkeredFloor(EditorGui editor) {
        ProjectionPane right = editor.projection("right");
        editor.gui.click("#add-rectangle");
        Vec3 middle = editor.model().scene().objects().get(2).placement().position();
        Point2D centre = place(right, middle.x(), middle.y(), middle.z());
        Point2D top = place(right, middle.x(), middle.y() + 1, middle.z()).add(0, -27);
        editor.gui.drag(right, top.getX(), top.getY(), centre.getX() + (centre.getY() - top.getY()), centre.getY());
        assertThat(Math.abs(editor.model().scene().objects().get(2).placement().rotation().x())).isEqualTo(90);
        ProjectionPane above = editor.projection("top");
        Point2D corner = place(above, middle.x() + 1, 0, middle.z() + 1).add(7, 7);
        editor.gui.hold(KeyCode.SHIFT);
        editor.gui.drag(above, corner.getX(), corner.getY(), corner.getX() + 60, corner.getY() + 60);
        editor.gui.letGo(KeyCode.SHIFT);
        assertThat(editor.model().scene().objects().get(2).placement().scale().x()).isGreaterThan(1.5);
        choose(editor, "#material", 1);
        choose(editor, "#pattern", 1);
        assertThat(((Material) editor.model().scene().objects().get(2).material()).pattern()).isInstanceOf(Checkerboard.class);
        editor.gui.click("#placement-position-y");
        editor.gui.act(() -> ((TextField) editor.gui.stage().getScene().lookup("#placement-position-y")).setText("-1/2"));
        editor.gui.keys(KeyCode.ENTER);
        assertThat(editor.model().scene().objects().get(2).placement().position().y()).isEqualTo(-0.5);
    }

    private static void secondLight(EditorGui editor) {
        editor.gui.click("#add-point-light");
        Vec3 at = LightMoves.place(editor.model().scene().lights().get(1));
        drag(editor, editor.projection("front"), at, at.plus(new Vec3(-3, 1, 0)));
        assertThat(LightMoves.place(editor.model().scene().lights().get(1)).x()).isLessThan(at.x() - 2);
    }

    /** Full HD, which is cancelled, and something small, which is saved. */
    private static void render(EditorGui editor) {
        editor.gui.keys(KeyCode.CONTROL, KeyCode.R);
        Stage stage = Gui.on(() -> (Stage) Window.getWindows().stream()
                .filter(window -> window.getScene().getRoot().getId().equals("render-pane")).findFirst().orElseThrow());
        try (Gui renders = Gui.open(() -> stage)) {
            renders.keys(KeyCode.ESCAPE);
            renders.click("#render-ask");
            enter(renders, "#render-width", "1920");
            enter(renders, "#render-height", "1080");
            renders.click("#render-start");
            renders.until("it has begun", () -> said(renders, "#render-status").contains("%"));
            renders.click("#render-cancel");
            renders.until("it says that it was cancelled", () -> said(renders, "#render-status").startsWith("Cancelled"));
            renders.click("#render-ask");
            enter(renders, "#render-width", "160");
            enter(renders, "#render-height", "90");
            renders.click("#render-start");
            renders.until("it is done", () -> said(renders, "#render-status").startsWith("Done"));
            assertThat(editor.text("#status-render")).startsWith("Done");
            renders.keys(KeyCode.CONTROL, KeyCode.S);
            renders.until("the picture is saved", () -> said(renders, "#render-message").equals("bowl.png saved"));
        }
    }

    private static void assertSame(BufferedImage saved, Image expected) {
        assertThat(saved.getWidth() + "x" + saved.getHeight()).isEqualTo(expected.width() + "x" + expected.height());
        for (int y = 0; y < expected.height(); y++) {
            for (int x = 0; x < expected.width(); x++) {
                assertThat(saved.getRGB(x, y)).isEqualTo(expected.argb(x, y));
            }
        }
    }

    /** Chooses by the number of an option, from 0 on. */
    private static void choose(EditorGui editor, String box, int option) {
        editor.gui.click(box);
        editor.gui.act(() -> ((ComboBox<?>) editor.gui.stage().getScene().lookup(box)).getSelectionModel().select(option));
        editor.gui.act(() -> ((ComboBox<?>) editor.gui.stage().getScene().lookup(box)).hide());
    }

    private static void enter(Gui window, String field, String text) {
        window.click(field);
        window.act(() -> ((TextField) window.stage().getScene().lookup(field)).setText(text));
    }

    /** For JavaFX's thread: what the label says in the tab that is shown. */
    private static String said(Gui window, String label) {
        return window.stage().getScene().getRoot().lookupAll(label).stream().filter(BuildSceneTest::isShown)
                .map(node -> Objects.requireNonNullElse(((Labeled) node).getText(), "")).findFirst().orElse("");
    }

    private static boolean isShown(Node node) {
        return node.isVisible() && (node.getParent() == null || isShown(node.getParent()));
    }

    private static void click(EditorGui editor, ProjectionPane pane, Vec3 at) {
        Point2D point = place(pane, at.x(), at.y(), at.z());
        editor.gui.click(pane, point.getX(), point.getY());
    }

    private static void drag(EditorGui editor, ProjectionPane pane, Vec3 from, Vec3 to) {
        Point2D a = place(pane, from.x(), from.y(), from.z());
        Point2D b = place(pane, to.x(), to.y(), to.z());
        editor.gui.drag(pane, a.getX(), a.getY(), b.getX(), b.getY());
    }
}
