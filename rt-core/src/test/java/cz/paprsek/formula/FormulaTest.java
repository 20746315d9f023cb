package cz.paprsek.formula;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FormulaTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "2 | 2", "-2 | -2", "+3.5 | 3.5", ".5 | 0.5", "1e-3 | 0.001", "2E2 | 200", "1,5 | 1.5", " 1 / 4 | 0.25", "2+3*4 | 14", "(2+3)*4 | 20",
        "2-3-4 | -5", "16/4/2 | 2", "2^3^2 | 512", "-2^2 | -4", "2^-1 | 0.5", "--2 | 2", "sqrt(16) | 4", "sin(90) | 1", "2*pi/pi | 2", "45° | 45",
        "3−1 | 2", "2×3 | 6", "0 | 0", "7 % 3 | 1", "-7 % 3 | -1", "mod(-7, 3) | 2", "mod(7, -3) | -2", "min(3, 1, 2) | 1", "max(3; 1; 2) | 3", "6÷4 | 1.5"})
    void sumsHaveTheirValues(String text, double value) {
        assertThat(Formula.value(text)).isCloseTo(value, within(1e-15));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "1 < 2 | 1", "2 <= 1 | 0", "2 >= 2 | 1", "1 == 1 | 1", "1 != 1 | 0", "1 ≤ 2 | 1", "1 and 0 | 0", "1 or 0 | 1", "not 0 | 1", "!3 | 0", "not 1 == 0 | 1",
        "1 < 2 ? 5 : 6 | 5", "0 ? 5 : 0 ? 6 : 7 | 7", "1 ? 2 : 1/0 | 2", "1 + 1 > 1 and 2 > 1 or 0 | 1", "3 > 2 == 1 | 1", "clamp(5, 0, 1) | 1", "mix(2, 4, 0.25) | 2.5",
        "round(2.5) | 3", "round(-2.5) | -2", "floor(-0.5) | -1", "ceil(0.2) | 1", "abs(-3) | 3", "sign(-3) | -1", "hypot(3, 4) | 5", "atan2(1, 1) | 45",
        "cbrt(27) | 3", "ln(exp(2)) | 2", "log10(1000) | 3", "cos(60) | 0.5", "asin(1) | 90", "acos(0) | 90", "atan(1) | 45", "tan(45) | 1"})
    void choicesAndFunctionsHaveTheirValues(String text, double value) {
        assertThat(Formula.value(text)).isCloseTo(value, within(1e-12));
    }

    @Test
    void numbersAreReadToTheLastDigit() {
        assertThat(Formula.value("0.1")).isEqualTo(0.1);
        assertThat(Formula.value("1.7976931348623157e308")).isEqualTo(Double.MAX_VALUE);
        assertThat(Formula.value("1/3")).isEqualTo(1.0 / 3);
    }

    @Test
    void namesStandForWhatIsGiven() {
        Formula formula = Formula.of("i % 2 == 0 ? r*i : -r_2");
        assertThat(formula.names()).containsExactly("i", "r", "r_2");
        assertThat(formula.value(Values.of(Map.of("i", 4.0, "r", 0.5, "r_2", 3.0)))).isEqualTo(2);
        assertThat(formula.value(Values.of(Map.of("i", 3.0, "r", 0.5, "r_2", 3.0)))).isEqualTo(-3);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", " ", "1+", "1 2", "(1", "1)", "*2", "1..2", "0x10", "1e", "2d", "1 ? 2", "sqrt(1, 2)", "min(1)", "sqrt()", "1,", "{1}", "1 = 1", "a.b", "x y"})
    void whatIsNoFormulaIsRefusedInWords(String text) {
        assertThatThrownBy(() -> Formula.of(text)).isInstanceOf(FormulaException.class).hasMessageMatching(".*(must stand here|takes .* but has).*");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "abc | 1 | \"abc\" is not a number", "2 + NaN | 5 | not a number", "Infinity | 1 | not a number", "2*sqrt 2 | 8 | must stand here", "2*sqrt | 3 | in parentheses",
        "teth*2 | 1 | did you mean \"teeth\"?", "sqr(2) | 1 | did you mean \"sqrt\"?", "1 + (2 * ) | 10 | must stand here", "(1 + 2 | 7 | \")\" must stand here"})
    void mistakesAreToldWithTheirColumn(String text, int column, String message) {
        assertThatThrownBy(() -> Formula.of(text).value(Values.of(Map.of("teeth", 3.0))))
                .isInstanceOfSatisfying(FormulaException.class, wrong -> assertThat(wrong.column()).isEqualTo(column)).hasMessageContaining(message);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"1/0 | 2", "1 + 0/0 | 6", "sqrt(-1) | 1", "1e999 | 1", "9^999 | 2", "2*asin(2) | 3", "ln(0) | 1", "10^308*10 | 7", "5 % 0 | 3"})
    void whatHasNoFiniteValueIsRefused(String text, int column) {
        assertThatThrownBy(() -> Formula.value(text)).hasMessageContaining("has no finite value")
                .isInstanceOfSatisfying(FormulaException.class, wrong -> assertThat(wrong.column()).isEqualTo(column));
    }

    @ParameterizedTest
    @ValueSource(strings = {"(", "-", "2^", "1?", "1+", "sqrt(", "not "})
    void endlessNestingIsRefusedRatherThanOverflowing(String piece) {
        assertThatThrownBy(() -> Formula.of(piece.repeat(100_000))).isInstanceOf(FormulaException.class);
        assertThatThrownBy(() -> Formula.of(piece.repeat(900 / piece.length()))).isInstanceOf(FormulaException.class);
    }

    @Test
    void theLongestFormulasTakeNoTime() {
        assertThat(Formula.value("1" + "+1".repeat(499))).isEqualTo(500);
        assertThat(Formula.value("2" + "^1".repeat(40))).isEqualTo(2);
        long start = System.nanoTime();
        IntStream.range(0, 100).forEach(i -> Formula.value("9" + "*9".repeat(300)));
        assertThat((System.nanoTime() - start) / 1e9).isLessThan(5);
    }

    @Test
    void whatLooksRandomIsEvenAndAlwaysTheSame() {
        assertThat(Formula.value("rand(1)")).isEqualTo(Formula.value("rand(1, 0)")).isNotEqualTo(Formula.value("rand(2)")).isNotEqualTo(Formula.value("rand(1, 1)"));
        assertThat(Formula.value("rand(0)")).isEqualTo(Formula.value("rand(-0)"));
        Formula formula = Formula.of("rand(i, 7)");
        double[] values = IntStream.range(0, 10_000).mapToDouble(i -> formula.value(Values.of(Map.of("i", (double) i)))).toArray();
        assertThat(Arrays.stream(values)).allMatch(value -> value >= 0 && value < 1);
        // The mean of so many has a standard deviation of 1/√12 / 100.
        assertThat(IntStream.range(0, values.length).mapToDouble(i -> values[i]).average().orElseThrow()).isCloseTo(0.5, within(0.012));
        double squares = IntStream.range(1, values.length).mapToDouble(i -> (values[i] - 0.5) * (values[i - 1] - 0.5)).average().orElseThrow();
        assertThat(squares).isCloseTo(0, within(0.005));
    }
}
