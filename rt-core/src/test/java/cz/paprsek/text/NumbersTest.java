package cz.paprsek.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class NumbersTest {
    @ParameterizedTest
    @CsvSource({"2, 2", "0.1, 0.1", "1e-7, 1e-7", "2e-3, 0.002", "1234567890123456, 1234567890123456", "1e23, 1e23", "2.0E23, 2e23", "1e7, 1e7",
        "0.30000000000000004, 0.30000000000000004", "-1.5, -1.5", "9007199254740993, 9007199254740992"})
    void aNumberIsWrittenAsPeopleWould(double number, String text) {
        assertThat(Numbers.text(number)).isEqualTo(text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"2", "-0.5", "+3", ".5", "2.", "1e-7", "2.5E3", "0"})
    void whatPeopleWriteIsANumber(String text) {
        assertThat(Numbers.parsed(text)).hasValue(Double.parseDouble(text));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-", "1d", "2f", "0x1p3", "NaN", "Infinity", "1e999", "1,5", "1e", "1 2", "\u0663"})
    void whatOnlyJavaTakesIsNone(String text) {
        assertThat(Numbers.parsed(text)).isEmpty();
    }

    @Test
    void noShorterTextReadsBackAsTheSameNumber() {
        Random random = new Random(2);
        for (int i = 0; i < 100_000; i++) {
            double number = (random.nextDouble() * 2 - 1) * Math.pow(10, random.nextInt(18) - 8);
            String text = Numbers.text(number);
            assertThat(Double.parseDouble(text)).isEqualTo(number);
            int digits = new BigDecimal(text).stripTrailingZeros().precision();
            BigDecimal shorter = new BigDecimal(number).round(new MathContext(Math.max(1, digits - 1)));
            assertThat(digits == 1 || shorter.doubleValue() != number).as("%s could be %s", text, shorter).isTrue();
        }
    }
}
