package cz.paprsek.fx.view.render;

import cz.paprsek.formula.Formula;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.text.Numbers;
import java.util.function.DoublePredicate;

/** A field for a number, also as a small sum such as 1/255; what is out of range is marked, and has no value. */
final class RealField extends CheckedField {
    private final Texts texts;
    private final DoublePredicate range;

    RealField(String id, String hint, Texts texts, DoublePredicate range, double first) {
        super(id, hint, hint, 4);
        this.texts = texts;
        this.range = range;
        set(first);
    }

    void set(double value) {
        setText(texts.number(Numbers.text(value)));
    }

    /** The number; only if it is valid. */
    double get() {
        return Formula.value(getText());
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
