package cz.paprsek.format.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Words are read eight bytes at a time, over the ends of buffers and up to the end of a file. */
class TextLinesTest {
    private static final String[] FORMATS = {"%.1f", "%.3f", "%.7f", "%.8f", "%.9f", "%.17f", "%e", "%.16e", "%+.0f", "%.0f", "%08.2f"};

    /** As the platform's own reader of numbers has them, to the last bit. */
    @ParameterizedTest
    @CsvSource({"1, 3", "2, 1", "3, 40", "4, 9000"})
    void numbersAreExact(long seed, int perLine) throws IOException {
        Random random = new Random(seed);
        List<String> written = new ArrayList<>();
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 18_000; i++) {
            written.add(String.format(Locale.ROOT, FORMATS[random.nextInt(FORMATS.length)], (random.nextDouble() - 0.5) * StrictMath.pow(10, random.nextInt(22) - 9)));
            text.append(i == 0 ? "" : i % perLine == 0 ? List.of("\n", "\r\n", " \r").get(random.nextInt(3)) : random.nextBoolean() ? " " : "\t ").append(written.get(i));
        }
        TextLines lines = new TextLines(new ByteArrayInputStream(text.toString().getBytes(StandardCharsets.UTF_8)), false);
        for (int i = 0; i < written.size(); i++) {
            assertThat(i % perLine > 0 || lines.next()).isTrue();
            assertThat(lines.nextNumber("a number")).as(written.get(i)).isEqualTo(Double.parseDouble(written.get(i)));
            assertThat(lines.line()).isEqualTo(1 + i / perLine);
        }
        assertThat(lines.hasMore() || lines.next()).isFalse();
    }
}
