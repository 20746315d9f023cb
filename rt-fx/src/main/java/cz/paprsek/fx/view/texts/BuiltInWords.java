package cz.paprsek.fx.view.texts;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.collections.ListChangeListener;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Labeled;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TextInputControl;
import javafx.scene.control.Tooltip;
import javafx.stage.Stage;
import javafx.stage.Window;
import org.jspecify.annotations.Nullable;

/**
 * The words of JavaFX's own menus of text fields and of its choosers of colours, which it has in fewer languages than the window: they are replaced when these
 * are shown. For JavaFX's thread only.
 */
public final class BuiltInWords implements AutoCloseable {
    private static final String KEYS = "javafx.";
    /** Style classes of what chooses colours: below a field, and the window for a colour of one's own. */
    private static final List<String> COLOURS = List.of(".color-palette-region", ".color-palette", ".custom-color-dialog");
    private static final List<String> WORDS = List.of(
            "undo", "redo", "cut", "copy", "paste", "delete", "select-all", "select", "custom-color...", "custom-colors", "remove-color", "current-color", "new-color",
            "opacity", "save", "use", "cancel", "hue", "saturation", "brightness", "red", "green", "blue", "transparent", "black", "cyan", "dark-blue", "dark-cyan", "dark-gray",
            "dark-green", "dark-magenta", "dark-red", "gray", "light-blue", "light-cyan", "light-gray", "light-green", "light-yellow", "lime", "magenta", "maroon",
            "medium-blue", "navy", "olive", "orange", "pink", "purple", "teal", "white", "yellow");

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
        if (window instanceof ContextMenu menu) {
            if (menu.getOwnerNode() instanceof TextInputControl) {
                menu.getItems().forEach(this::translate);
            }
        } else if (window instanceof Tooltip tooltip) {
            Node owner = tooltip.getOwnerNode();
            if (owner != null && owner.getStyleClass().contains("color-square")) {
                word(tooltip.getText()).ifPresent(tooltip::setText);
            }
        } else if (window.getScene() != null && COLOURS.stream().anyMatch(style -> window.getScene().getRoot().lookup(style) != null)) {
            translate(window.getScene().getRoot());
            if (window instanceof Stage stage) {
                word(stage.getTitle()).ifPresent(stage::setTitle);
            }
        }
    }

    private void translate(MenuItem item) {
        word(item.getText()).ifPresent(item::setText);
    }

    /** Some are filled anew when another way to name colours is chosen. */
    private void translate(Node node) {
        if (node instanceof Labeled labeled && !labeled.textProperty().isBound()) {
            word(labeled.getText()).ifPresent(labeled::setText);
            if (labeled.getProperties().putIfAbsent(BuiltInWords.class, this) == null) {
                labeled.textProperty().addListener((property, old, now) -> word(now).filter(text -> !text.equals(now)).ifPresent(labeled::setText));
            }
        }
        if (node instanceof Parent parent) {
            parent.getChildrenUnmodifiable().forEach(this::translate);
        }
    }

    private Optional<String> word(@Nullable String text) {
        if (text == null) {
            return Optional.empty();
        }
        boolean hasColon = text.endsWith(":");
        return Optional.ofNullable(known.get(hasColon ? text.substring(0, text.length() - 1) : text)).map(word -> texts.get().of(KEYS + word) + (hasColon ? ":" : ""));
    }
}
