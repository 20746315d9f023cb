package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javafx.scene.Parent;
import javafx.scene.control.Labeled;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
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
            editor.gui.hold(KeyCode.CONTROL);
            editor.gui.hold(KeyCode.ALT);
            editor.gui.keys(KeyCode.R);
            editor.gui.letGo(KeyCode.ALT);
            editor.gui.letGo(KeyCode.CONTROL);
            editor.gui.until("it is asked", () -> pictures().lookup("#render-dialog").isVisible());
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
