package cz.paprsek.sheet;

import java.util.Objects;

/**
 * A line of an exercise.
 *
 * @param formula what is to be found, or what is given, in symbols
 * @param numbers the formula with numbers in place of symbols; empty if there is nothing to put in
 * @param result the number
 * @param isGiven whether the number stands there; else there is room to write it
 */
record Line(String formula, String numbers, String result, boolean isGiven) {
    Line {
        Objects.requireNonNull(formula, "formula");
        Objects.requireNonNull(numbers, "numbers");
        Objects.requireNonNull(result, "result");
    }
}
