package cz.paprsek.fx.view.render.fields;

import cz.paprsek.formula.Formula;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.text.Numbers;
import java.util.function.DoublePredicate;

/** A field for a number, also as a small sum such as 1/255; what is out of range is marked, and has no value. */
public final class RealField extends CheckedField {
    private final Texts texts;
    private final DoublePredicate range;

    /**
     * @param range whether a number is allowed
     * @param first the number that is shown at first
     */
    public RealField(String id, String hint, Texts texts, DoublePredicate range, double first) {
        super(id, hint, hint, 4);
        this.texts = texts;
        this.range = range;
        set(first);
    }

    /** Shows a number. */
    public void set(double value) {
        setText(texts.number(Numbers.text(value)));
    }

    /** The number; only if it is valid. */
    public double get() {
        return Formula.value(getText());
    }

    @Override
    public String word() {
        return validProperty().get() ? Numbers.text(get()) : getText();
    }

    @Override
    public void say(String word) {
        setText(texts.number(word));
    }

    @Override
    boolean isInRange(String text) {
        try {
            return range.test(Formula.value(text));
        } catch (IllegalArgumentException refused) {
            return false;
        }
    }
}
