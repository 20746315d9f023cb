package cz.paprsek.fx.view.render.fields;

import java.util.Arrays;
import java.util.List;
import javafx.beans.Observable;
import javafx.beans.binding.Bindings;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;

/** Questions one below the other: what is asked, the controls that answer, and below these a line that says what is wrong with them, as long as something is. */
public class FormGrid extends GridPane {
    private int rows;

    /** Looks as all such forms do. */
    protected final void lookLikeAForm() {
        getStyleClass().add("form-grid");
    }

    /** Adds a question whose fields say themselves what they want. */
    protected final void ask(String label, List<? extends CheckedField> fields, Node... nodes) {
        ask(label, refusal(fields), nodes);
    }

    /** Adds a question, and what is wrong with its answer; empty if nothing is. */
    protected final void ask(String label, ObservableValue<String> refusal, Node... nodes) {
        HBox controls = new HBox(6, nodes);
        controls.setAlignment(Pos.CENTER_LEFT);
        Label asked = new Label(label);
        asked.setMinWidth(Region.USE_PREF_SIZE);
        Label wrong = new Label();
        wrong.getStyleClass().add("field-refusal");
        wrong.setId(nodes[0].getId() + "-refusal");
        wrong.textProperty().bind(refusal);
        wrong.visibleProperty().bind(Bindings.createBooleanBinding(() -> !wrong.getText().isEmpty(), wrong.textProperty()));
        wrong.managedProperty().bind(wrong.visibleProperty());
        addRow(rows++, asked, controls);
        add(wrong, 1, rows++);
    }

    /** What the first field wants that has no number within its range; empty if all have one. Fields that are disabled do not count. */
    public static ObservableValue<String> refusal(List<? extends CheckedField> fields) {
        Observable[] all = fields.stream().flatMap(field -> Arrays.stream(new Observable[] {field.textProperty(), field.validProperty(), field.disabledProperty()})).toArray(Observable[]::new);
        return Bindings.createStringBinding(() -> fields.stream().filter(field -> !field.isDisabled() && !field.validProperty().get())
                .findFirst().map(CheckedField::wanted).orElse(""), all);
    }
}
