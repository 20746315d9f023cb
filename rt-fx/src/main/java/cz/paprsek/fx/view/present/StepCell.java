package cz.paprsek.fx.view.present;

import cz.paprsek.render.explain.text.Step;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import javafx.css.PseudoClass;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.text.Text;
import javafx.scene.text.TextFlow;

/** A line of the exercise in large type, broken where it must; blank, only its formula. */
final class StepCell extends ListCell<Step> {
    /** After it a line could be broken, within a number; not before a zero-width space that forbids it. */
    private static final Pattern DECIMAL_COMMA = Pattern.compile("(?<=[0-9]),(?=[0-9])");
    private static final PseudoClass LINKED = PseudoClass.getPseudoClass("linked");
    /** Beside the words, also for a bar to scroll by: rows are measured before it is known whether there is one. */
    private static final double BESIDE = 60;

    private final Text name = new Text();
    private final Text equation = new Text();
    private final TextFlow both = new TextFlow(name, equation);
    private final ListView<Step> list;
    private final IntPredicate isHidden;
    private final Predicate<Step> isLinked;

    /**
     * A cell of a list.
     *
     * @param isLinked whether a line speaks of what the mouse is at
     */
    StepCell(ListView<Step> list, IntPredicate isHidden, Predicate<Step> isLinked) {
        this.list = list;
        this.isHidden = isHidden;
        this.isLinked = isLinked;
        name.getStyleClass().add("present-name");
        equation.getStyleClass().add("present-equation");
        setPrefWidth(0);
        both.maxWidthProperty().bind(list.widthProperty().subtract(BESIDE));
        both.prefWidthProperty().bind(list.widthProperty().subtract(BESIDE));
    }

    @Override
    protected double computePrefHeight(double width) {
        double room = list.getWidth() - BESIDE;
        return isEmpty() || room <= 0 ? super.computePrefHeight(width) : snappedTopInset() + Math.ceil(both.prefHeight(room)) + snappedBottomInset();
    }

    @Override
    protected void updateItem(Step step, boolean empty) {
        super.updateItem(step, empty);
        boolean isShown = !empty && step != null;
        setGraphic(isShown ? both : null);
        pseudoClassStateChanged(LINKED, isShown && isLinked.test(step));
        if (isShown) {
            name.setText(step.name().isEmpty() ? "" : step.name() + "  ");
            String text = isHidden.test(getIndex()) && !step.result().isEmpty() ? step.formula() + " = ……" : step.equation();
            equation.setText(DECIMAL_COMMA.matcher(text).replaceAll(",\ufeff").replace("+ ", "+\u00a0").replace("= ", "=\u00a0"));
        }
    }
}
