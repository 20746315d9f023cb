package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.model.property.Trait.Unit;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;

/** A number with its unit, arrows, and a menu of values with names if it has such. */
final class NumberEditor implements PropertyEditor {
    private final HBox box = new HBox();
    private final NumberField field;

    NumberEditor(Property property, PropertyEdit edit, Texts texts) {
        field = new NumberField(property, edit, texts);
        box.setAlignment(Pos.CENTER_LEFT);
        box.getStyleClass().add("number-editor");
        HBox.setHgrow(field, Priority.ALWAYS);
        box.getChildren().addAll(field, new SpinnerButtons(field));
        if (property.trait().unit() != Unit.NONE) {
            Label unit = new Label(texts.of(property.trait().unit() == Unit.DEGREES ? "unit.degrees" : "unit.pixels"));
            unit.getStyleClass().add("unit");
            box.getChildren().add(unit);
        }
        if (!property.trait().presets().isEmpty()) {
            box.getChildren().add(presets(property, edit, texts));
        }
    }

    @Override
    public Node node() {
        return box;
    }

    NumberField field() {
        return field;
    }

    @Override
    public void show(Scene scene) {
        field.show(scene);
    }

    private static MenuButton presets(Property property, PropertyEdit edit, Texts texts) {
        MenuButton menu = new MenuButton();
        menu.setId(String.join("-", property.path()) + "-presets");
        menu.setAccessibleText(texts.of("sheet.presets"));
        menu.getStyleClass().add("presets");
        property.trait().presets().forEach(preset -> {
            MenuItem item = new MenuItem(texts.of(preset.name()) + "  " + texts.number(Steps.text(preset.value())));
            item.setOnAction(event -> edit.change(scene -> property.write(scene, preset.value())));
            menu.getItems().add(item);
        });
        return menu;
    }
}
