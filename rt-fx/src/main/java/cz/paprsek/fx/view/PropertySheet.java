package cz.paprsek.fx.view;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Item;
import javafx.scene.control.Label;
import javafx.scene.layout.BorderPane;

/** The properties of what is selected. */
public final class PropertySheet extends BorderPane {
    public PropertySheet(EditorModel model, Texts texts) {
        setId("property-sheet");
        Label label = new Label();
        setTop(label);
        model.stateProperty().addListener((property, old, now) ->
                label.setText(String.join(", ", now.selection().stream().map(Item::toString).toList())));
    }
}
