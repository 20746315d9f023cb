package cz.paprsek.cli.value;

import picocli.CommandLine.TypeConversionException;

/** A number above 0, as in {@code 0.004} or {@code 1/255}. */
public record Part(double value) {
    public static Part parse(String text) {
        String[] numbers = text.split("/", 2);
        try {
            double value = Double.parseDouble(numbers[0]) / (numbers.length == 1 ? 1 : Double.parseDouble(numbers[1]));
            if (value > 0 && Double.isFinite(value)) {
                return new Part(value);
            }
        } catch (NumberFormatException notANumber) {
            // Answered below, like a number out of range.
        }
        throw new TypeConversionException("expected a number above 0 such as 0.004 or 1/255, but found '" + text + "'");
    }
}
