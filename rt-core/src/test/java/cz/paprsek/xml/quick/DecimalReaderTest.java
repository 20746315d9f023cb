package cz.paprsek.xml.quick;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DecimalReaderTest {
    private final DecimalReader reader = new DecimalReader();

    @ParameterizedTest
    @ValueSource(strings = {"0", "-0", "+1", "1.", ".5", "-.5e1", "1e5", "1E-5", "1e+5", "007", "0.1", "123456789012345678", "1234567890123456789",
        "9007199254740993", "9007199254740992.5", "9007199254740991.49999999999", "1e22", "1e23", "8.5e22", "1.7976931348623157e308", "1e309", "4.9e-324",
        "2.4703282292062327e-324", "1e-400", "0.000000000000000000000000000001", "0e99999999999", "1e-99999999999", "100000000000000000000000000",
        "5e-324", "2.2250738585072014e-308", "0.0000000000000000000000000000000000000000000000000000000000000000001"})
    void theNumberIsTheNearest(String text) {
        check(text);
    }

    /** Numbers of all lengths and sizes, those that programs write, and those that lie in the middle between two doubles or hardly beside it. */
    @Test
    void everyNumberIsReadAsJavaReadsIt() {
        Random random = new Random(11);
        for (int i = 0; i < 50_000; i++) {
            check(Double.toString(random.nextDouble() * 2 - 1));
            check(Double.toString(random.nextGaussian() * Math.pow(10, random.nextInt(60) - 30)));
            check((random.nextLong() >>> random.nextInt(64)) + "e" + (random.nextInt(140) - 70));
            double low = (1 + random.nextInt(1 << random.nextInt(31))) * Math.pow(2, random.nextInt(100) - 50);
            String middle = new BigDecimal(low).add(new BigDecimal(Math.nextUp(low))).divide(BigDecimal.valueOf(2)).toString();
            check(middle);
            check(middle.substring(0, Math.min(middle.length(), 19)));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"+", "-", ".", "e5", "1e", "1e+", "1e5.", "1.2.3", "--1", "0x1p3", "1d", "1f", "NaN", "INF", "Infinity", "1 ", " 1", "1e5x", "1_0", "é"})
    void whatIsNoDecimalIsRefused(String text) {
        assertThatExceptionOfType(NumberFormatException.class).isThrownBy(() -> read(text));
    }

    private void check(String text) {
        // By their bits: 0 and -0 are not the same.
        assertThat(Double.doubleToLongBits(read(text))).as(text).isEqualTo(Double.doubleToLongBits(Double.parseDouble(text)));
    }

    private double read(String text) {
        byte[] bytes = ("1" + text + "1").getBytes(StandardCharsets.ISO_8859_1);
        return reader.read(bytes, 1, bytes.length - 1);
    }
}
