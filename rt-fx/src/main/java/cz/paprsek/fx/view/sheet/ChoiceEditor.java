package cz.paprsek.fx.view.sheet;

import cz.paprsek.scene.Scene;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.util.StringConverter;

/** One of several possibilities. */
final class ChoiceEditor<T> implements PropertyEditor {
    private final ComboBox<T> box = new ComboBox<>();
    private final Function<Scene, List<T>> options;
    private final Function<Scene, Optional<T>> read;
    private boolean showing;

    ChoiceEditor(String id, String mixed, Function<T, String> text, Function<Scene, List<T>> options,
            Function<Scene, Optional<T>> read, Consumer<T> choose) {
        this.options = options;
        this.read = read;
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
            T chosen = box.getValue();
            if (!showing && chosen != null) {
                choose.accept(chosen);
            }
        });
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
