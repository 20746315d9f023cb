package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.format.model.Digits;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Digits and powers of ten against the platform's own reader of numbers, to the last bit. */
class DigitsTest {
    private static final int TRIES = 300_000;

    @Test
    void roundedIsTheNearestDouble() {
        Random random = new Random(3);
        int left = 0;
        for (int i = 0; i < TRIES; i++) {
            long digits = Math.floorMod(random.nextLong(), 1_000_000_000_000_000_000L) >> random.nextInt(60);
            int power = random.nextInt(131) - 65;
            double found = Digits.rounded(digits, power);
            if (Double.isNaN(found)) {
                left++;
            } else {
                assertThat(found).as(digits + "e" + power).isEqualTo(Double.parseDouble(digits + "e" + power));
            }
        }
        assertThat(left).as("left to others").isLessThan(TRIES / 40);
    }

    /** Between two doubles, exactly or all but exactly, rounding is to the even one. */
    @Test
    void halvesAreRoundedToEven() {
        Random random = new Random(4);
        for (int i = 0; i < TRIES / 10; i++) {
            long half = (1L << 53 | (random.nextLong() & ((1L << 53) - 1))) * 2 | 1;
            int power = random.nextInt(3);
            for (long digits = half - 1; digits <= half + 1; digits++) {
                long scaled = digits * (power == 0 ? 1 : power == 1 ? 5 : 25);
                double found = scaled < 1_000_000_000_000_000_000L ? Digits.rounded(scaled, -power) : Double.NaN;
                if (!Double.isNaN(found)) {
                    assertThat(found).as(scaled + "e" + -power).isEqualTo(Double.parseDouble(scaled + "e" + -power));
                }
            }
        }
    }

    @Test
    void digitsAreReadAcrossWords() {
        for (int length = 0; length <= Digits.FITTING; length++) {
            byte[] text = ("x" + "123456789012345678".substring(0, length) + " y").getBytes(StandardCharsets.UTF_8);
            int end = Digits.end(text, 1, text.length);
            assertThat(end).isEqualTo(1 + length);
            assertThat(Digits.read(0, text, 1, end)).isEqualTo(length == 0 ? 0 : Long.parseLong("123456789012345678".substring(0, length)));
        }
        byte[] zeros = "0.00120".getBytes(StandardCharsets.UTF_8);
        assertThat(Digits.leadingZeros(zeros, 0, zeros.length)).isEqualTo(3);
    }
}
