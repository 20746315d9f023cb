package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.ref.WeakReference;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javafx.scene.Parent;
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
}
