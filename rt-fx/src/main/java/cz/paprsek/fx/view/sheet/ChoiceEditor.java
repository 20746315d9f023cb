package cz.paprsek.fx.view.sheet;

import cz.paprsek.scene.Scene;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.skin.ComboBoxListViewSkin;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.util.StringConverter;
import org.jspecify.annotations.Nullable;

/**
 * One of several possibilities. Up, Down, Enter and the space bar open the list; there the arrows only move, Enter or a click chooses, and
 * Escape leaves all as it was.
 */
final class ChoiceEditor<T> implements PropertyEditor {
    private final ComboBox<T> box = new ComboBox<>();
    private final Function<Scene, List<T>> options;
    private final Function<Scene, Optional<T>> read;
    private final Consumer<T> choose;
    private @Nullable T before;
    private boolean showing;
    private boolean cancelled;

    ChoiceEditor(String id, String mixed, Function<T, String> text, Function<Scene, List<T>> options,
            Function<Scene, Optional<T>> read, Consumer<T> choose) {
        this.options = options;
        this.read = read;
        this.choose = choose;
        box.setId(id);
        box.setMaxWidth(Double.MAX_VALUE);
        box.setMinWidth(0);
        box.setPromptText(mixed);
        box.setConverter(new StringConverter<>() {
            @Override
            public String toString(T option) {
                return option == null ? "" : text.apply(option);
            }

            @Override
            public T fromString(String written) {
                throw new UnsupportedOperationException("nothing is written here");
            }
        });
        box.setOnAction(event -> {
            if (!box.isShowing()) {
                chosen();
            }
        });
        box.setOnShowing(event -> {
            before = box.getValue();
            cancelled = false;
        });
        box.setOnHidden(event -> hidden());
        box.skinProperty().addListener((property, was, is) -> {
            if (is instanceof ComboBoxListViewSkin<?> skin) {
                // The list hears of the key first, and keeps it.
                skin.getPopupContent().addEventFilter(KeyEvent.KEY_PRESSED, event -> cancelled |= event.getCode() == KeyCode.ESCAPE);
            }
        });
        box.addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
    }

    private void pressed(KeyEvent event) {
        boolean opens = switch (event.getCode()) {
            case UP, DOWN, ENTER, SPACE -> !box.isShowing() && !event.isShortcutDown();
            default -> false;
        };
        if (opens) {
            box.show();
            event.consume();
        }
    }

    private void hidden() {
        T was = before;
        if (cancelled) {
            showing = true;
            box.setValue(was);
            showing = false;
        } else if (!Objects.equals(was, box.getValue())) {
            chosen();
        }
    }

    private void chosen() {
        T value = box.getValue();
        if (!showing && value != null) {
            choose.accept(value);
        }
    }

    @Override
    public Node node() {
        return box;
    }

    @Override
    public void show(Scene scene) {
        showing = true;
        List<T> now = options.apply(scene);
        if (!now.equals(box.getItems())) {
            box.getItems().setAll(now);
        }
        box.setValue(read.apply(scene).orElse(null));
        showing = false;
    }
}
