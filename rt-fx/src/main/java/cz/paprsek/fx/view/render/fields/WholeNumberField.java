package cz.paprsek.fx.view.render.fields;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.FormulaException;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** A field for a whole number within a range, also as a small sum such as 1920/4. Up and down count; what is out of range is marked, and has no value. */
public final class WholeNumberField extends CheckedField {
    private final int least;
    private final String name;
    private int most;

    /** @param hint what it is for; the range is told behind it */
    public WholeNumberField(String id, String hint, int least, int most, int columns) {
        super(id, hint, hint + " (" + least + "–" + most + ")", columns);
        this.least = least;
        this.most = most;
        name = hint;
        addEventFilter(KeyEvent.KEY_PRESSED, this::count);
        set(least);
    }

    /** Sets the largest number. */
    public void setMost(int number) {
        most = number;
        setAccessibleHelp(name + " (" + least + "–" + most + ")");
        judge();
    }

    /** Shows a number. */
    public void set(int value) {
        setText(Integer.toString(value));
    }

    /** The number; only if it is valid. */
    public int get() {
        return (int) Formula.value(getText());
    }

    @Override
    public String word() {
        return validProperty().get() ? Integer.toString(get()) : getText();
    }

    @Override
    boolean isInRange(String text) {
        try {
            double number = Formula.value(text);
            return number == Math.rint(number) && number >= least && number <= most;
        } catch (FormulaException none) {
            return false;
        }
    }

    private void count(KeyEvent event) {
        int by = event.getCode() == KeyCode.UP ? 1 : event.getCode() == KeyCode.DOWN ? -1 : 0;
        if (by != 0) {
            set(isInRange(getText()) ? Math.max(least, Math.min(most, get() + by)) : least);
            event.consume();
        }
    }
}
