package cz.paprsek.fx.view.render;

import java.util.function.UnaryOperator;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.css.PseudoClass;
import javafx.scene.control.TextField;
import javafx.scene.control.TextFormatter;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** A field for a whole number within a range. Up and down count; what is out of range is marked, and has no value. */
final class WholeNumberField extends TextField {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");

    private final int least;
    private final int most;
    private final ReadOnlyBooleanWrapper valid = new ReadOnlyBooleanWrapper(true);

    WholeNumberField(String id, String hint, int least, int most, int columns) {
        this.least = least;
        this.most = most;
        setId(id);
        setPrefColumnCount(columns);
        setTooltip(new Tooltip(hint + " (" + least + "–" + most + ")"));
        setAccessibleText(hint);
        UnaryOperator<TextFormatter.Change> digitsOnly = change -> change.getControlNewText().matches("\\d{0,6}") ? change : null;
        setTextFormatter(new TextFormatter<>(digitsOnly));
        textProperty().addListener((property, old, now) -> {
            valid.set(isInRange(now));
            pseudoClassStateChanged(REFUSED, !valid.get());
        });
        addEventFilter(KeyEvent.KEY_PRESSED, this::count);
        set(least);
    }

    ReadOnlyBooleanProperty validProperty() {
        return valid.getReadOnlyProperty();
    }

    void set(int value) {
        setText(Integer.toString(value));
    }

    /** The number; only if it is valid. */
    int get() {
        return Integer.parseInt(getText());
    }

    private boolean isInRange(String text) {
        return !text.isEmpty() && Integer.parseInt(text) >= least && Integer.parseInt(text) <= most;
    }

    private void count(KeyEvent event) {
        int by = event.getCode() == KeyCode.UP ? 1 : event.getCode() == KeyCode.DOWN ? -1 : 0;
        if (by != 0) {
            set(valid.get() ? Math.max(least, Math.min(most, get() + by)) : least);
            event.consume();
        }
    }
}
