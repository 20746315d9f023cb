package cz.paprsek.fx.view.render.fields;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.FormulaException;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.text.Numbers;
import java.util.function.UnaryOperator;
import javafx.scene.control.TextFormatter;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** A field for an exposure, also as a small sum such as 4/3. Up and down change it by thirds of a stop, as cameras do; what is out of range is marked, and has no value. */
public final class StopsField extends CheckedField {
    private static final int STEPS = 3;

    private final Texts texts;

    public StopsField(String id, Texts texts) {
        super(id, texts.of("render.exposure.hint"), texts.of("render.exposure.hint") + " (±" + RenderSettings.MOST_STOPS + ")", 4);
        this.texts = texts;
        UnaryOperator<TextFormatter.Change> sumsOnly = change -> change.getControlNewText().matches("[-+*/%^().,\\d ]{0,24}") ? change : null;
        setTextFormatter(new TextFormatter<>(sumsOnly));
        addEventFilter(KeyEvent.KEY_PRESSED, this::step);
        set(0);
    }

    /** Shows a number of stops. */
    public void set(double stops) {
        setText(texts.number(Numbers.text(stops)));
    }

    /** The number of stops; only if it is valid. */
    public double get() {
        return value(getText());
    }

    private static double value(String text) {
        return Formula.value(text.replaceFirst("^\\s*\\+", ""));
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
            return Math.abs(value(text)) <= RenderSettings.MOST_STOPS;
        } catch (FormulaException none) {
            return false;
        }
    }

    private void step(KeyEvent event) {
        int by = event.getCode() == KeyCode.UP ? 1 : event.getCode() == KeyCode.DOWN ? -1 : 0;
        if (by != 0) {
            double thirds = validProperty().get() ? Math.rint(STEPS * get()) + by : 0;
            set(Math.max(-RenderSettings.MOST_STOPS, Math.min(RenderSettings.MOST_STOPS, Math.rint(thirds * 1000 / STEPS) / 1000)));
            event.consume();
        }
    }
}
