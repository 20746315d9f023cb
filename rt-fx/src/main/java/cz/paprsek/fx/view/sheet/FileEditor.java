package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.view.command.FileFinder;
import cz.paprsek.fx.view.command.FileFinder.Kind;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.height.HeightField;
import java.util.Set;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.kordamp.ikonli.javafx.FontIcon;

/** The name of a picture or a mesh, which can be typed, and a button that asks for one. */
final class FileEditor implements PropertyEditor {
    /** What an object and an operand call their shape. */
    private static final Set<String> SHAPES = Set.of("shape", "solid");

    private final Property property;
    private final Texts texts;
    private final TextEditor name;
    private final Button choose = new Button("", new FontIcon("mdi2f-folder-open-outline"));
    private final HBox box;
    private Kind kind = Kind.PICTURE;

    FileEditor(Property property, PropertyEdit edit, Texts texts, FileFinder finder) {
        String id = String.join("-", property.path());
        name = new TextEditor(id, edit, scene -> property.read(scene).map(Object::toString).orElse(""), property::write);
        choose.setId(id + "-choose");
        this.property = property;
        this.texts = texts;
        say();
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

    private void say() {
        String text = texts.of(kind == Kind.MESH ? "sheet.choose-mesh" : "sheet.choose-picture");
        choose.setAccessibleText(text);
        Hint.of(choose).set(text);
    }

    /** Relief is of pictures, other shapes are of triangles. */
    private boolean isOfTriangles(Scene scene) {
        return SHAPES.contains(property.path().get(0)) && property.target().read(scene).stream().noneMatch(record ->
                (record instanceof SceneObject object && object.shape() instanceof HeightField) || (record instanceof Operand operand && operand.solid() instanceof HeightField));
    }

    @Override
    public void show(Scene scene) {
        name.show(scene);
        Kind now = isOfTriangles(scene) ? Kind.MESH : Kind.PICTURE;
        if (now != kind) {
            kind = now;
            say();
        }
    }
}
