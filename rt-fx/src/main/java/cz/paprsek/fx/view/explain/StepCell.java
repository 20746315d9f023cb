package cz.paprsek.fx.view.explain;

import cz.paprsek.render.explain.text.Step;
import javafx.scene.control.TableCell;
import javafx.scene.layout.Region;
import javafx.scene.text.Text;

/** A line of the exercise in as many lines as it needs, broken between numbers rather than within them. */
final class StepCell extends TableCell<Step, String> {
    private static final double PADDING = 16;
    private final Text text = new Text();

    StepCell() {
        text.getStyleClass().add("explain-step");
        text.wrappingWidthProperty().bind(widthProperty().subtract(PADDING));
        setPrefHeight(Region.USE_COMPUTED_SIZE);
    }

    @Override
    protected void updateItem(String item, boolean empty) {
        super.updateItem(item, empty);
        text.setText(empty || item == null ? "" : item.replace(", ", ",\u00a0").replace("+ ", "+\u00a0").replace("= ", "=\u00a0"));
        setGraphic(empty ? null : text);
    }
}
