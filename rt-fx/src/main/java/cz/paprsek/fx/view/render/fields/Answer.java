package cz.paprsek.fx.view.render.fields;

import java.util.function.Consumer;
import java.util.function.Supplier;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ChoiceBox;

/**
 * What a control says, as a word that is remembered.
 *
 * @param name what it answers
 * @param get what it says now
 * @param set has it say something; nothing happens if it has no such answer
 */
public record Answer(String name, Supplier<String> get, Consumer<String> set) {
    public static Answer of(String name, CheckedField field) {
        return new Answer(name, field::word, field::say);
    }

    /** Of a choice among values, by what they are called in the program. */
    public static <T> Answer of(String name, ChoiceBox<Named<T>> box) {
        return new Answer(name, () -> box.getValue().value().toString(),
                word -> box.getItems().stream().filter(item -> item.value().toString().equals(word)).findFirst().ifPresent(box.getSelectionModel()::select));
    }

    public static Answer of(String name, CheckBox box) {
        return new Answer(name, () -> Boolean.toString(box.isSelected()), word -> box.setSelected(Boolean.parseBoolean(word)));
    }
}
