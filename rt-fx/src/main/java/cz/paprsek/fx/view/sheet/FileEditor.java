package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.kordamp.ikonli.javafx.FontIcon;

/** The name of a picture, which can be typed, and a button that asks for one. */
final class FileEditor implements PropertyEditor {
    private final TextEditor name;
    private final HBox box;

    FileEditor(Property property, PropertyEdit edit, Texts texts, PictureFinder finder) {
        String id = String.join("-", property.path());
        name = new TextEditor(id, edit, scene -> property.read(scene).map(Object::toString).orElse(""), property::write);
        Button choose = new Button("", new FontIcon("mdi2f-folder-open-outline"));
        choose.setId(id + "-choose");
        choose.setAccessibleText(texts.of("sheet.choose-picture"));
        choose.setTooltip(new Tooltip(texts.of("sheet.choose-picture")));
        choose.setOnAction(event -> {
            try {
                finder.find(choose.getScene().getWindow()).ifPresent(found -> edit.change(scene -> property.write(scene, found)));
            } catch (IllegalArgumentException refused) {
                edit.refuse(refused);
            }
        });
        HBox.setHgrow(name.node(), Priority.ALWAYS);
        box = new HBox(4, name.node(), choose);
    }

    @Override
    public Node node() {
        return box;
    }

    @Override
    public void show(Scene scene) {
        name.show(scene);
    }
}
