package cz.paprsek.fx.view.texts;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.collections.ListChangeListener;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TextInputControl;
import javafx.stage.Window;
import org.jspecify.annotations.Nullable;

/**
 * The words of JavaFX's own menus of text fields, which it has in other languages than the window: they are replaced when these are shown. For JavaFX's thread only.
 */
public final class BuiltInWords implements AutoCloseable {
    private static final String KEYS = "javafx.";
    private static final List<String> WORDS = List.of("undo", "redo", "cut", "copy", "paste", "delete", "select-all", "select");

    private final Supplier<Texts> texts;
    /** Which word it is, by what it is called in any language: what was shown in one may be shown again in another. */
    private final Map<String, String> known = new HashMap<>();
    private final ListChangeListener<Window> shown = this::shown;

    /** Begins at once, and goes on until closed. */
    public BuiltInWords(Supplier<Texts> texts) {
        this.texts = texts;
        for (Locale language : Texts.LANGUAGES) {
            Texts all = Texts.in(language);
            WORDS.forEach(word -> known.putIfAbsent(all.of(KEYS + word), word));
        }
        Window.getWindows().addListener(shown);
    }

    /**
     * Makes JavaFX speak English from now on, which is what is replaced here: in the system's language it might say what nobody here knows. Before the first window.
     *
     * @return the system's language
     */
    public static Locale speakEnglish() {
        Locale system = Locale.getDefault();
        Locale.setDefault(Locale.ENGLISH);
        return system;
    }

    @Override
    public void close() {
        Window.getWindows().removeListener(shown);
    }

    private void shown(ListChangeListener.Change<? extends Window> change) {
        while (change.next()) {
            change.getAddedSubList().forEach(this::translate);
        }
    }

    private void translate(Window window) {
        if (window instanceof ContextMenu menu && menu.getOwnerNode() instanceof TextInputControl) {
            menu.getItems().forEach(this::translate);
        }
    }

    private void translate(MenuItem item) {
        word(item.getText()).ifPresent(item::setText);
    }

    private Optional<String> word(@Nullable String text) {
        return Optional.ofNullable(text).map(known::get).map(word -> texts.get().of(KEYS + word));
    }
}
