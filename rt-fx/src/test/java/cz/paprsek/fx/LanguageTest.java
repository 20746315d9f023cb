package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.view.present.PresenterPane;
import java.lang.ref.WeakReference;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.scene.Parent;
import javafx.scene.control.ButtonBase;
import javafx.stage.Stage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LanguageTest {
    @TempDir
    Path folder;

    @Test
    void contentsOfTheWindowInAnotherLanguageAreLetGo() {
        try (EditorGui editor = new EditorGui(folder, Templates.read("test"))) {
            WeakReference<Parent> old = Gui.on(() -> new WeakReference<>(editor.gui.stage().getScene().getRoot()));
            for (String language : List.of("cs", "en", "cs")) {
                editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag(language)));
            }
            editor.gui.until("the first content of the window is gone", () -> {
                System.gc();
                return old.get() == null;
            });
            assertThat(editor.dialogs.faults).isEmpty();
        }
    }

    @Test
    void theOpenPresenterGoesOnInAnotherLanguageAtTheSamePixel() {
        try (EditorGui editor = new EditorGui(folder, Templates.read("test"))) {
            editor.gui.act(() -> editor.editor.presenter().show(Optional.empty()));
            Stage window = editor.editor.presenter().stage().orElseThrow();
            editor.gui.act(() -> presenter(window).show(7, 9));
            assertThat(presenter(window).title()).startsWith("Pixel 7, 9");
            assertThat(tooltip(window, "present-play")).isEqualTo("Space");
            editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
            assertThat(presenter(window).title()).startsWith("Bod 7, 9");
            assertThat(window.getTitle()).startsWith("Proč");
            assertThat(tooltip(window, "present-play")).isEqualTo("Mezerník");
            assertThat(tooltip(window, "present-back")).isEqualTo("←");
            editor.gui.act(window::close);
            assertThat(editor.dialogs.faults).isEmpty();
        }
    }

    private static PresenterPane presenter(Stage window) {
        return (PresenterPane) window.getScene().getRoot();
    }

    private static String tooltip(Stage window, String id) {
        return Gui.on(() -> ((ButtonBase) window.getScene().lookup("#" + id)).getTooltip().getText());
    }
}
