package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.view.explain.ExplainPane;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.control.MenuButton;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.TreeView;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Explaining pixels of the camera's picture in the whole window. */
class ExplainModeTest {
    @TempDir
    Path folder;

    private EditorGui editor;

    @BeforeEach
    void open() {
        editor = new EditorGui(folder, scene());
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
    }

    /** Looks at the glass ball. */
    private static Scene scene() {
        Scene scene = Templates.read("showcase");
        return scene.withSettings(scene.settings().withSamples(1)).withCamera(Camera.lookingAt(scene.camera().position(), new Vec3(0.55, 0.5, 1)).withFovy(25));
    }

    @AfterEach
    void close() {
        editor.close();
    }

    private Node picture() {
        return editor.gui.node(".live-picture");
    }

    /** Points at a share of the picture's frame, and clicks. */
    private void click(double across, double down) {
        Bounds frame = editor.gui.node(".picture-frame").getBoundsInParent();
        editor.gui.click(picture(), frame.getMinX() + across * frame.getWidth(), frame.getMinY() + down * frame.getHeight());
    }

    private void hover(double across, double down) {
        Bounds frame = editor.gui.node(".picture-frame").getBoundsInParent();
        editor.gui.moveTo(picture(), frame.getMinX() + across * frame.getWidth(), frame.getMinY() + down * frame.getHeight());
    }

    private ExplainPane pane() {
        return (ExplainPane) editor.gui.node("#explain-pane");
    }

    private void startExplaining() {
        editor.gui.click("#camera-explain");
        editor.gui.until("the picture is complete in its new size", editor.editor::isPictureComplete);
    }

    private int column() {
        ExplainPane pane = pane();
        return Gui.on(() -> pane.explained().orElseThrow().column());
    }

    @SuppressWarnings("unchecked")
    private TreeView<Outline> tree() {
        return (TreeView<Outline>) editor.gui.node("#explain-tree");
    }

    @Test
    void hoveringExplainsAClickStaysAndArrowKeysStep() {
        startExplaining();
        hover(0.2, 0.8);
        int first = column();
        hover(0.5, 0.5);
        assertThat(column()).isGreaterThan(first);
        click(0.5, 0.5);
        int clicked = column();
        hover(0.7, 0.6);
        assertThat(column()).isEqualTo(clicked);
        Camera camera = editor.model().scene().camera();
        editor.gui.keys(KeyCode.RIGHT);
        assertThat(column()).isEqualTo(clicked + 1);
        assertThat(editor.model().scene().camera()).as("arrows move the pixel, not the camera").isEqualTo(camera);
        click(0.5, 0.5);
        hover(0.2, 0.8);
        assertThat(column()).as("the second click lets go").isEqualTo(first);
    }

    @Test
    void choosingARaySelectsWhatItHits() {
        startExplaining();
        click(0.5, 0.5);
        assertThat(editor.model().selection()).hasSize(1);
        editor.gui.act(() -> editor.model().select());
        TreeView<Outline> tree = tree();
        editor.gui.act(tree::requestFocus);
        editor.gui.keys(KeyCode.DOWN);
        editor.gui.keys(KeyCode.DOWN);
        Outline chosen = Gui.on(() -> tree.getSelectionModel().getSelectedItem().getValue());
        assertThat(editor.model().selection())
                .isEqualTo(java.util.Set.of(ScenePath.body(chosen.ray().encounter().orElseThrow().place().surface().part().object().index())));
        ExplainPane pane = pane();
        assertThat(Gui.on(() -> pane.drawnProperty().get().orElseThrow().highlighted())).isEqualTo(chosen.name());
    }

    @Test
    void theTreeFollowsTheScene() {
        startExplaining();
        click(0.5, 0.5);
        TreeView<Outline> tree = tree();
        assertThat(Gui.on(() -> tree.getRoot().getChildren().size())).isPositive();
        editor.gui.act(() -> editor.model().edit(
                cz.paprsek.fx.model.Label.of(cz.paprsek.fx.model.Label.Edit.DELETE), scene -> scene.withObjects(java.util.List.of())));
        editor.gui.until("the pixel shows the background", () -> tree.getRoot().getValue().ray().encounter().isEmpty());
    }

    @Test
    void theKeyStartsAndEscapeLeavesAndClearsAll() {
        editor.gui.act(picture()::requestFocus);
        editor.gui.keys(KeyCode.E);
        click(0.5, 0.5);
        assertThat(editor.gui.node("#explain-title").isVisible()).isTrue();
        ExplainPane pane = pane();
        editor.gui.keys(KeyCode.ESCAPE);
        assertThat(Gui.on(() -> pane.drawnProperty().get())).isEmpty();
        assertThat(Gui.on(() -> pane.getScene() == null)).isTrue();
        assertThat(((ToggleButton) editor.gui.node("#camera-explain")).isSelected()).isFalse();
        click(0.5, 0.5);
        assertThat(editor.model().selection()).as("a click selects again").hasSize(1);
    }

    @Test
    void inTheTreeOfObjectsTheKeyIsALetterToLookFor() {
        editor.gui.act(() -> editor.gui.node("#tree-list").requestFocus());
        editor.gui.keys(KeyCode.E);
        assertThat(Gui.on(() -> ((TextField) editor.gui.node("#tree-find")).getText())).isEqualTo("e");
        assertThat(((ToggleButton) editor.gui.node("#camera-explain")).isSelected()).isFalse();
    }

    @Test
    void theTreeIsSavedAsTextJsonAndDrawing() throws IOException {
        startExplaining();
        click(0.5, 0.5);
        MenuButton export = (MenuButton) editor.gui.node("#explain-export");
        for (String kind : java.util.List.of("txt", "json", "html", "svg")) {
            Path file = folder.resolve("tree." + kind);
            editor.dialogs.tree = Optional.of(file);
            editor.gui.act(() -> export.getItems().stream().filter(item -> ("explain-save-" + kind).equals(item.getId())).findFirst().orElseThrow().fire());
            assertThat(Files.readString(file)).contains(kind.equals("svg") ? "<svg" : kind.equals("html") ? "<h1>Worksheet" : kind.equals("json") ? "\"kind\":\"refracted\"" : "E  from the eye");
        }
        assertThat(editor.dialogs.asked).last().asString().startsWith("tree ").endsWith(".svg");
        assertThat(editor.text("#explain-message")).isEqualTo("tree.svg saved");
    }

    @Test
    void picturesToLookAt() {
        startExplaining();
        click(0.5, 0.45);
        TreeView<Outline> tree = tree();
        editor.gui.act(() -> tree.getSelectionModel().select(2));
        editor.menu("view-menu-fit-selection");
        assertThat(Screenshots.save(editor.gui, "explain-mode-light")).isNotEmptyFile();
        editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
        startExplaining();
        click(0.5, 0.45);
        TreeView<Outline> czech = tree();
        editor.gui.act(() -> czech.getSelectionModel().select(2));
        editor.menu("view-menu-fit-selection");
        assertThat(czech.getRoot().getValue().name()).isEqualTo("E");
        assertThat(Screenshots.save(editor.gui, "explain-mode-light-czech")).isNotEmptyFile();
        editor.gui.act(() -> editor.editor.theme().set(Theme.DARK));
        assertThat(Screenshots.save(editor.gui, "explain-mode-dark-czech")).isNotEmptyFile();
    }

    @Test
    void aPictureTooLargeForTheClassIsRefusedInALine() {
        Scene large = scene().withSettings(scene().settings().withSize(32768, 32768));
        editor.gui.act(() -> editor.model().open(large));
        editor.gui.act(() -> editor.editor.presenter().show(Optional.empty()));
        assertThat(editor.status()).startsWith("There is not enough memory for a picture of 32");
        assertThat(editor.editor.presenter().stage()).isEmpty();
        assertThat(editor.dialogs.faults).isEmpty();
    }
}
