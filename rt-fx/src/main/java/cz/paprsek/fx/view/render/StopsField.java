package cz.paprsek.fx.view.render;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.FormulaException;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.text.Numbers;
import java.util.function.UnaryOperator;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.css.PseudoClass;
import javafx.scene.control.TextField;
import javafx.scene.control.TextFormatter;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** A field for an exposure, also as a small sum such as 4/3. Up and down change it by thirds of a stop, as cameras do; what is out of range is marked, and has no value. */
final class StopsField extends TextField {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");
    private static final int STEPS = 3;

    private final Texts texts;
    private final ReadOnlyBooleanWrapper valid = new ReadOnlyBooleanWrapper(true);

    StopsField(Texts texts) {
        this.texts = texts;
        setId("render-exposure");
        setPrefColumnCount(4);
        setTooltip(new Tooltip(texts.of("render.exposure.hint")));
        setAccessibleText(texts.of("render.exposure.hint"));
        UnaryOperator<TextFormatter.Change> sumsOnly = change -> change.getControlNewText().matches("[-+*/%^().,\\d ]{0,24}") ? change : null;
        setTextFormatter(new TextFormatter<>(sumsOnly));
        textProperty().addListener((property, old, now) -> {
            valid.set(isValid());
            pseudoClassStateChanged(REFUSED, !valid.get());
        });
        addEventFilter(KeyEvent.KEY_PRESSED, this::step);
        set(0);
    }

    ReadOnlyBooleanProperty validProperty() {
        return valid.getReadOnlyProperty();
    }

    void set(double stops) {
        setText(texts.number(Numbers.text(stops)));
    }

    /** The number of stops; only if it is valid. */
    double get() {
        return Formula.value(getText().replaceFirst("^\\s*\\+", ""));
    }

    private boolean isValid() {
        try {
            return Math.abs(get()) <= RenderSettings.MOST_STOPS;
        } catch (FormulaException none) {
            return false;
        }
    }

    private void step(KeyEvent event) {
        int by = event.getCode() == KeyCode.UP ? 1 : event.getCode() == KeyCode.DOWN ? -1 : 0;
        if (by != 0) {
            double thirds = valid.get() ? Math.rint(STEPS * get()) + by : 0;
            set(Math.max(-RenderSettings.MOST_STOPS, Math.min(RenderSettings.MOST_STOPS, Math.rint(thirds * 1000 / STEPS) / 1000)));
            event.consume();
        }
    }
}
