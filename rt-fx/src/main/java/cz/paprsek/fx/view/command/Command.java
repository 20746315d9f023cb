package cz.paprsek.fx.view.command;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Shortcut;
import cz.paprsek.fx.view.texts.Texts;
import java.util.Optional;
import javafx.beans.binding.Bindings;
import javafx.beans.value.ObservableBooleanValue;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Button;
import javafx.scene.control.MenuItem;
import javafx.scene.input.KeyCombination;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * Something that a user can do, by menu, key or button.
 *
 * @param key its text's key, and, with dashes for dots, the id of its menu item and, with "-button", of its button
 * @param text what it is called now
 * @param keys the keys that do it; empty for none
 * @param icon for a button and the menu; empty for none
 * @param disabled while it cannot be done
 */
public record Command(String key, ObservableValue<String> text, Optional<KeyCombination> keys, Optional<Ikon> icon, ObservableBooleanValue disabled,
        Runnable action) {

    public static Command of(String key, Texts texts, Runnable action) {
        return new Command(key, Bindings.createStringBinding(() -> texts.of(key)), Optional.empty(), Optional.empty(),
                Bindings.createBooleanBinding(() -> false), action);
    }

    public Command keys(String combination) {
        return new Command(key, text, Optional.of(Shortcut.of(combination)), icon, disabled, action);
    }

    public Command icon(Ikon value) {
        return new Command(key, text, keys, Optional.of(value), disabled, action);
    }

    public Command disabledIf(ObservableBooleanValue value) {
        return new Command(key, text, keys, icon, value, action);
    }

    public Command called(ObservableValue<String> value) {
        return new Command(key, value, keys, icon, disabled, action);
    }

    public MenuItem menuItem() {
        MenuItem item = new MenuItem();
        item.setId(key.replace('.', '-'));
        item.textProperty().bind(text);
        item.disableProperty().bind(disabled);
        keys.ifPresent(item::setAccelerator);
        icon.ifPresent(code -> item.setGraphic(new FontIcon(code)));
        item.setMnemonicParsing(false);
        item.setOnAction(event -> action.run());
        return item;
    }

    public Button button() {
        Button button = new Button();
        button.setId(key.replace('.', '-') + "-button");
        icon.ifPresent(code -> button.setGraphic(new FontIcon(code)));
        Hint.of(button).bind(Bindings.createStringBinding(
                () -> text.getValue() + keys.map(k -> " (" + k.getDisplayText() + ")").orElse(""), text));
        button.accessibleTextProperty().bind(text);
        button.disableProperty().bind(disabled);
        button.setFocusTraversable(false);
        button.setOnAction(event -> action.run());
        return button;
    }
}
