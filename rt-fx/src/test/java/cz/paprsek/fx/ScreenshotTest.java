package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.scene.ScenePath;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pictures of the main states, in target/screenshots, to be looked at by people. */
class ScreenshotTest {
    @TempDir
    Path folder;

    @Test
    void bothThemesAndLanguages() {
        try (EditorGui editor = new EditorGui(folder, Templates.read("showcase"))) {
            editor.gui.act(() -> editor.model().select(ScenePath.body(1)));
            shoot(editor, "window-light");
            editor.gui.act(() -> editor.editor.theme().set(Theme.DARK));
            shoot(editor, "window-dark");
            editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
            editor.gui.act(() -> editor.model().select(ScenePath.camera()));
            shoot(editor, "window-dark-czech");
        }
        try (EditorGui editor = new EditorGui(folder, Templates.read("test"), 1600, 1000)) {
            editor.gui.act(() -> editor.editor.theme().set(Theme.LIGHT));
            editor.gui.act(() -> editor.model().select(ScenePath.body(8), ScenePath.light(0)));
            shoot(editor, "window-light-1600x1000");
        }
    }

    private static void shoot(EditorGui editor, String name) {
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
        assertThat(Screenshots.save(editor.gui, name)).isNotEmptyFile();
    }
}
