package cz.paprsek.fx.view.explain;

import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.explain.text.Step;
import java.util.function.Function;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.DoubleBinding;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.scene.control.Label;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableView;

/** The worked exercise of one ray. */
final class StepTable extends TableView<Step> {
    /** Room for a scroll bar. */
    private static final double BAR = 18;
    private static final double NAMES = 0.24;
    /** Room for the longest word of a name. */
    private static final double LEAST_NAME = 92;

    StepTable(Texts texts) {
        setId("explain-steps");
        setPlaceholder(new Label(""));
        DoubleBinding room = widthProperty().subtract(BAR);
        DoubleBinding names = Bindings.createDoubleBinding(() -> Math.max(LEAST_NAME, NAMES * room.get()), room);
        column(texts.of("explain.what"), names, Step::name);
        column(texts.of("explain.how"), room.subtract(names), Step::equation);
    }

    private void column(String title, DoubleBinding width, Function<Step, String> text) {
        TableColumn<Step, String> column = new TableColumn<>(title);
        column.setSortable(false);
        column.setReorderable(false);
        column.setCellFactory(table -> new StepCell());
        column.setCellValueFactory(cell -> new ReadOnlyStringWrapper(text.apply(cell.getValue())));
        column.prefWidthProperty().bind(width);
        getColumns().add(column);
    }
}
