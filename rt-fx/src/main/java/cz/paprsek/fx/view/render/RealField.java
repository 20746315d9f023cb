package cz.paprsek.fx.view.render;

import cz.paprsek.fx.model.property.Expression;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.text.Numbers;
import java.util.function.DoublePredicate;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.css.PseudoClass;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;

/** A field for a number, also as a small sum such as 1/255; what is out of range is marked, and has no value. */
final class RealField extends TextField {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");

    private final Texts texts;
    private final DoublePredicate range;
    private final ReadOnlyBooleanWrapper valid = new ReadOnlyBooleanWrapper(true);

    RealField(String id, String hint, Texts texts, DoublePredicate range, double first) {
        this.texts = texts;
        this.range = range;
        setId(id);
        setPrefColumnCount(4);
        setTooltip(new Tooltip(hint));
        setAccessibleText(hint);
        textProperty().addListener((property, old, now) -> {
            valid.set(isInRange(now));
            pseudoClassStateChanged(REFUSED, !valid.get());
        });
        set(first);
    }

    ReadOnlyBooleanProperty validProperty() {
        return valid.getReadOnlyProperty();
    }

    void set(double value) {
        setText(texts.number(Numbers.text(value)));
    }

    /** The number; only if it is valid. */
    double get() {
        return Expression.value(getText());
    }

    private boolean isInRange(String text) {
        try {
            return range.test(Expression.value(text));
        } catch (IllegalArgumentException refused) {
            return false;
        }
    }
}
