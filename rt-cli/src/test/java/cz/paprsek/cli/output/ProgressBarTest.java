package cz.paprsek.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.Columns;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ProgressBarTest {
    @Test
    void aLineSaysHowFarItIsHowFastAndHowLongTheRestTakes() {
        assertThat(ProgressBar.line(80, "glass.xml", 0.42, 1.25e6, 7.2))
                .isEqualTo("glass.xml  42 % [########            ] 1.3 M eye rays/s  0:08 left");
        assertThat(ProgressBar.line(80, "a", 1, 0, 3_601)).endsWith("1:00:01 left");
    }

    @Test
    void whatDenoisesIsNotSaidToBeDone() {
        assertThat(ProgressBar.denoising(80, "room.xml")).isEqualTo("room.xml traced; taking the noise out");
        assertThat(ProgressBar.denoising(30, "room.xml")).isEqualTo("traced; taking the noise out");
    }

    @Test
    void nothingIsSaidOfTheRestWhileNothingIsKnown() {
        assertThat(ProgressBar.line(80, "a", 0, 0, Double.NaN)).doesNotContain("left");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4, 8, 12, 20, 30, 40, 60, 79, 80, 81, 200})
    void aLineNeverFillsTheTerminal(int columns) {
        for (String name : new String[] {"a.xml", "scenes/some/where/with a very long name indeed.xml", "場面の名前がとても長い.xml", "e\u0301te\u0301.xml"}) {
            String line = ProgressBar.line(columns, name, 0.999, 123.4e6, 359_999);
            assertThat(Columns.of(line)).as(line).isLessThan(columns);
            assertThat(Columns.of(ProgressBar.denoising(columns, name))).isLessThan(columns);
        }
        assertThat(ProgressBar.line(columns, "a", 0.5, 1e6, 9)).matches(columns > 20 ? ".*50 %.* left" : ".*");
    }

    @Test
    void doubleWidthLettersCountTwiceAndAccentsNot() {
        assertThat(Columns.of("場面")).isEqualTo(4);
        assertThat(Columns.of("e\u0301")).isEqualTo(1);
        assertThat(Columns.end("abcdefgh", 6)).isEqualTo("...fgh");
    }
}
