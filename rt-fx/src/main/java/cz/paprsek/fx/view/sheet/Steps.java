package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.property.Trait;
import cz.paprsek.text.Numbers;
import java.math.BigDecimal;
import java.math.MathContext;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;

/** How numbers change step by step, and how they are shown. */
final class Steps {
    private static final MathContext SHOWN = new MathContext(7);
    private static final MathContext KEPT = new MathContext(12);

    private Steps() {}

    /** By how much a step changes a value: as its trait says, or else about a tenth of its size. */
    static double step(Trait trait, double value) {
        if (trait.step() > 0) {
            return trait.step();
        }
        double size = Math.abs(value);
        if (size == 0) {
            return 0.1;
        }
        int exponent = (int) Math.floor(Math.log10(size));
        return Double.parseDouble((size / Math.pow(10, exponent) < 5 ? "1e" : "5e") + (exponent - 1));
    }

    /** A value some steps further, within the trait's range and without the noise of binary fractions. */
    static double moved(Trait trait, double value, double by) {
        double moved = trait.clamp(value + by);
        return trait.kind() == Trait.Kind.WHOLE ? Math.rint(moved)
                : Double.isFinite(moved) ? new BigDecimal(moved).round(KEPT).doubleValue() : value;
    }

    /** Ten steps at once with Shift, a tenth of one with Ctrl or Alt. */
    static double factor(boolean shift, boolean fine) {
        return shift ? 10 : fine ? 0.1 : 1;
    }

    static double factor(KeyEvent event) {
        return factor(event.isShiftDown(), event.isAltDown());
    }

    static double factor(MouseEvent event) {
        return factor(event.isShiftDown(), event.isShortcutDown() || event.isAltDown());
    }

    /** A number as shown in a field: seven digits are enough to read; what is not touched keeps them all. */
    static String text(double value) {
        return Numbers.text(new BigDecimal(value).round(SHOWN).doubleValue());
    }
}
