package cz.paprsek.fx.view.render.fields;

import cz.paprsek.formula.Formula;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.text.Numbers;
import java.util.function.DoublePredicate;

/** A field for a number, also as a small sum such as 1/255; what is out of range is marked, and has no value. */
public class RealField extends CheckedField {
    private final Texts texts;
    private final DoublePredicate range;

    /**
     * One that is named by its hint.
     *
     * @param range whether a number is allowed
     * @param first the number that is shown at first
     */
    public static RealField of(String id, String hint, Texts texts, DoublePredicate range, double first) {
        return new RealField(id, hint, hint, texts, range, first);
    }

    /** @param name what it is for; the hint also says within which range */
    RealField(String id, String name, String hint, Texts texts, DoublePredicate range, double first) {
        super(id, name, hint, 4);
        this.texts = texts;
        this.range = range;
        setText(texts.number(Numbers.text(first)));
    }

    /** Shows a number. */
    public final void set(double value) {
        setText(texts.number(Numbers.text(value)));
    }

    /** The number; only if it is valid. */
    public final double get() {
        return value(getText());
    }

    /** Of a number with a sign, which a plus is too. */
    private static double value(String text) {
        return Formula.value(text.replaceFirst("^\\s*\\+", ""));
    }

    @Override
    public final String word() {
        return validProperty().get() ? Numbers.text(get()) : getText();
    }

    @Override
    public final void say(String word) {
        setText(texts.number(word));
    }

    @Override
    final boolean isInRange(String text) {
        try {
            return range.test(value(text));
        } catch (IllegalArgumentException refused) {
            return false;
        }
    }
}
