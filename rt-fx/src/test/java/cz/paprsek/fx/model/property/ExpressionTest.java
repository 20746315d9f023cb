package cz.paprsek.fx.model.property;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ExpressionTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "2 | 2", "-2 | -2", "+3.5 | 3.5", ".5 | 0.5", "1e-3 | 0.001", "2E2 | 200", "1,5 | 1.5", " 1 / 4 | 0.25", "2+3*4 | 14", "(2+3)*4 | 20",
        "2-3-4 | -5", "16/4/2 | 2", "2^3^2 | 512", "-2^2 | -4", "2^-1 | 0.5", "--2 | 2", "sqrt(16) | 4", "sin(90) | 1", "2*pi/pi | 2", "45° | 45",
        "3−1 | 2", "2×3 | 6", "0 | 0"})
    void sumsHaveTheirValues(String text, double value) {
        assertThat(Expression.value(text)).isCloseTo(value, within(1e-15));
    }

    @Test
    void numbersAreReadToTheLastDigit() {
        assertThat(Expression.value("0.1")).isEqualTo(0.1);
        assertThat(Expression.value("1.7976931348623157e308")).isEqualTo(Double.MAX_VALUE);
        assertThat(Expression.value("1/3")).isEqualTo(1.0 / 3);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", " ", "abc", "1+", "1 2", "(1", "1)", "*2", "1..2", "e5", "0x10", "NaN", "Infinity", "sqrt 2", "1e", "2d"})
    void whatIsNoSumIsRefusedInWords(String text) {
        assertThatThrownBy(() -> Expression.value(text)).isInstanceOf(IllegalArgumentException.class).hasMessageMatching(".*(must stand here|is not a number).*");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1/0", "0/0", "sqrt(-1)", "1e999", "9^999"})
    void whatHasNoFiniteValueIsRefused(String text) {
        assertThatThrownBy(() -> Expression.value(text)).hasMessageContaining("has no finite value");
    }

    @Test
    void endlessNestingIsRefusedRatherThanOverflowing() {
        assertThatThrownBy(() -> Expression.value("(".repeat(100_000))).isInstanceOf(IllegalArgumentException.class);
    }
}
