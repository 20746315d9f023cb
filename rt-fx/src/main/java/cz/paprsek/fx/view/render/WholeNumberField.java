package cz.paprsek.fx.view.render;

import java.util.function.UnaryOperator;
import javafx.scene.control.TextFormatter;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** A field for a whole number within a range. Up and down count; what is out of range is marked, and has no value. */
final class WholeNumberField extends CheckedField {
    private final int least;
    private final String name;
    private int most;

    WholeNumberField(String id, String hint, int least, int most, int columns) {
        super(id, hint, hint + " (" + least + "–" + most + ")", columns);
        this.least = least;
        this.most = most;
        name = hint;
        UnaryOperator<TextFormatter.Change> digitsOnly = change -> change.getControlNewText().matches("\\d{0,7}") ? change : null;
        setTextFormatter(new TextFormatter<>(digitsOnly));
        addEventFilter(KeyEvent.KEY_PRESSED, this::count);
        set(least);
    }

    /** Sets the largest number. */
    void setMost(int number) {
        most = number;
        getTooltip().setText(name + " (" + least + "–" + most + ")");
        judge();
    }

    void set(int value) {
        setText(Integer.toString(value));
    }

    /** The number; only if it is valid. */
    int get() {
        return Integer.parseInt(getText());
    }

    @Override
    boolean isInRange(String text) {
        return !text.isEmpty() && Integer.parseInt(text) >= least && Integer.parseInt(text) <= most;
    }

    private void count(KeyEvent event) {
        int by = event.getCode() == KeyCode.UP ? 1 : event.getCode() == KeyCode.DOWN ? -1 : 0;
        if (by != 0) {
            set(isInRange(getText()) ? Math.max(least, Math.min(most, get() + by)) : least);
            event.consume();
        }
    }
}
