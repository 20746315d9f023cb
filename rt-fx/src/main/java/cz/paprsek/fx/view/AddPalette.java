package cz.paprsek.fx.view;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Structure;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.function.Supplier;
import javafx.scene.control.Button;
import javafx.scene.control.MenuItem;
import javafx.scene.layout.FlowPane;

/** Buttons and menu items that add objects and lights. */
public final class AddPalette extends FlowPane {
    private final EditorModel model;
    private final Texts texts;
    private final Supplier<Vec3> place;

    /** @param place where new things are put, world space: where the user looks */
    public AddPalette(EditorModel model, Texts texts, Supplier<Vec3> place) {
        this.model = model;
        this.texts = texts;
        this.place = place;
        setId("add-palette");
        Button sphere = new Button(texts.of("kind.sphere"));
        sphere.setOnAction(event -> add());
        getChildren().add(sphere);
    }

    /** The same as a menu. */
    public List<MenuItem> menuItems() {
        MenuItem item = new MenuItem(texts.of("kind.sphere"));
        item.setOnAction(event -> add());
        return List.of(item);
    }

    private void add() {
        Vec3 p = place.get();
        model.editState(Label.of(Label.Edit.ADD, texts.of("kind.sphere")),
                state -> Structure.add(state, SceneObject.of(new Sphere(0.5)).at(p.x(), p.y(), p.z())));
    }
}
