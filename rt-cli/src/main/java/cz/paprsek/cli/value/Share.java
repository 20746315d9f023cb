package cz.paprsek.cli.value;

import picocli.CommandLine.TypeConversionException;

/** A share of a whole, 0–1, as in {@code 0.001} or {@code 0.1%}. */
public record Share(double value) {
    public static Share parse(String text) {
        boolean isPercent = text.endsWith("%");
        try {
            double value = Double.parseDouble(isPercent ? text.substring(0, text.length() - 1) : text) / (isPercent ? 100 : 1);
            if (value >= 0 && value <= 1) {
                return new Share(value);
            }
        } catch (NumberFormatException notANumber) {
            // Answered below, like a number out of range.
        }
        throw new TypeConversionException("expected a share such as 0.001 or 0.1%, but found '" + text + "'");
    }
}
