package cz.paprsek.formula;

import java.util.List;
import java.util.Objects;

/**
 * A formula that stands for a number in a scene file.
 *
 * @param elements those within the body, light or whatever it is that has the attribute, outermost first; none if it has it itself
 * @param attribute its name in files
 * @param index which of the numbers of the attribute it stands for, from 0
 * @param count how many numbers the attribute has there
 * @param formula without braces
 * @param value what it comes to, as it is written
 */
public record Written(List<String> elements, String attribute, int index, int count, String formula, String value) {
    public Written {
        elements = List.copyOf(elements);
        Objects.requireNonNull(attribute, "attribute");
        Objects.requireNonNull(formula, "formula");
        Objects.requireNonNull(value, "value");
    }
}
