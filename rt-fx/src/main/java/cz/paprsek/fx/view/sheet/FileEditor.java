package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.view.command.FileFinder;
import cz.paprsek.fx.view.command.FileFinder.Kind;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import java.util.Set;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.kordamp.ikonli.javafx.FontIcon;

/** The name of a picture or a mesh, which can be typed, and a button that asks for one. */
final class FileEditor implements PropertyEditor {
    /** What an object and an operand call their shape. */
    private static final Set<String> SHAPES = Set.of("shape", "solid");

    private final TextEditor name;
    private final HBox box;

    FileEditor(Property property, PropertyEdit edit, Texts texts, FileFinder finder) {
        String id = String.join("-", property.path());
        name = new TextEditor(id, edit, scene -> property.read(scene).map(Object::toString).orElse(""), property::write);
        Button choose = new Button("", new FontIcon("mdi2f-folder-open-outline"));
        choose.setId(id + "-choose");
        Kind kind = SHAPES.contains(property.path().get(0)) ? Kind.MESH : Kind.PICTURE;
        String text = texts.of(kind == Kind.MESH ? "sheet.choose-mesh" : "sheet.choose-picture");
        choose.setAccessibleText(text);
        choose.setTooltip(new Tooltip(text));
        choose.setOnAction(event -> {
            try {
                finder.find(kind, choose.getScene().getWindow()).ifPresent(found -> edit.change(scene -> property.write(scene, found)));
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
