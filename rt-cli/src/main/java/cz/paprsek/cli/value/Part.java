package cz.paprsek.cli.value;

import cz.paprsek.text.Numbers;
import picocli.CommandLine.TypeConversionException;

/** A number above 0, as in {@code 0.004} or {@code 1/255}. */
public record Part(double value) {
    public static Part parse(String text) {
        String[] numbers = text.split("/", 2);
        double value = Numbers.parsed(numbers[0]).orElse(-1) / (numbers.length == 1 ? 1 : Numbers.parsed(numbers[1]).orElse(0));
        if (value > 0 && Double.isFinite(value)) {
            return new Part(value);
        }
        throw new TypeConversionException("expected a number above 0 such as 0.004 or 1/255, but found '" + text + "'");
    }
}
