package cz.paprsek.fx.view;

import cz.paprsek.fx.model.EditorModel;
import javafx.scene.control.ListView;
import javafx.scene.layout.BorderPane;

/** The scene's camera, lights and objects, operands within their operations. */
public final class ObjectTree extends BorderPane {
    private final ListView<String> list = new ListView<>();

    public ObjectTree(EditorModel model, Texts texts) {
        setId("object-tree");
        setCenter(list);
        model.sceneProperty().addListener((property, old, now) -> show(model, texts));
        show(model, texts);
    }

    private void show(EditorModel model, Texts texts) {
        list.getItems().setAll(model.scene().objects().stream()
                .map(object -> object.name().isEmpty() ? texts.kind(object.shape()) : object.name()).toList());
    }
}
