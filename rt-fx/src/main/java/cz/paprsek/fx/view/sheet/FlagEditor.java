package cz.paprsek.fx.view.sheet;

import cz.paprsek.scene.Scene;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.scene.Node;
import javafx.scene.control.CheckBox;

/** A box that is ticked or not; in between if several things differ. */
final class FlagEditor implements PropertyEditor {
    private final CheckBox box = new CheckBox();
    private final Function<Scene, Optional<Object>> read;

    FlagEditor(String id, String name, Function<Scene, Optional<Object>> read, Consumer<Boolean> choose) {
        this.read = read;
        box.setId(id);
        box.setAccessibleText(name);
        box.setOnAction(event -> choose.accept(box.isSelected()));
    }

    @Override
    public Node node() {
        return box;
    }

    @Override
    public void show(Scene scene) {
        Optional<Object> value = read.apply(scene);
        box.setIndeterminate(value.isEmpty());
        box.setSelected(value.filter(Boolean.TRUE::equals).isPresent());
    }
}
