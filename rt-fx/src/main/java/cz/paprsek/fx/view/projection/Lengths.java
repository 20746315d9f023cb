package cz.paprsek.fx.view.projection;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Locale;

/** Lengths as they are read from a projection: as fine as a pixel shows. */
final class Lengths {
    private static final int MOST_DECIMALS = 12;

    private Lengths() {}

    static String text(double length, Viewport view, Locale locale) {
        return text("", length, view, locale);
    }

    /** With + or − before it. */
    static String signed(double length, Viewport view, Locale locale) {
        return text("+", length, view, locale);
    }

    private static String text(String flag, double length, Viewport view, Locale locale) {
        int decimals = Math.max(0, Math.min(MOST_DECIMALS, (int) Math.ceil(Math.log10(view.scale()))));
        // Not as a double, which would show the rest of a rounding as −0.00.
        BigDecimal shown = new BigDecimal(length).setScale(decimals, RoundingMode.HALF_EVEN);
        return String.format(locale, "%" + flag + "." + decimals + "f", shown);
    }
}
