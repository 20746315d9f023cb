package cz.paprsek.cli.value;

import cz.paprsek.text.Numbers;
import picocli.CommandLine.TypeConversionException;

/** A share of a whole, 0–1, as in {@code 0.001} or {@code 0.1%}. */
public record Share(double value) {
    public static Share parse(String text) {
        boolean isPercent = text.endsWith("%");
        double value = Numbers.parsed(isPercent ? text.substring(0, text.length() - 1) : text).orElse(-1) / (isPercent ? 100 : 1);
        if (value >= 0 && value <= 1) {
            return new Share(value);
        }
        throw new TypeConversionException("expected a share such as 0.001 or 0.1%, but found '" + text + "'");
    }
}
