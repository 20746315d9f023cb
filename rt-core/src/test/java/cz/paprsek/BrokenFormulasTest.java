package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The table of formulas that are broken one by one, which takes too long for every build, breaks what is there. */
class BrokenFormulasTest {
    private static final String TEXT = "\"((?:[^\"\\\\]|\\\\.)*)\"";
    private static final Pattern BREAK = Pattern.compile("new Break\\(" + TEXT + ",\\s*" + TEXT + ",\\s*" + TEXT + ",\\s*" + TEXT + "\\)");

    @Test
    void everyFormulaToBeBrokenStandsWhereTheTableSays() throws IOException {
        List<MatchResult> breaks = BREAK.matcher(Files.readString(Path.of("../.ci/BreakFormulas.java"))).results().toList();
        assertThat(breaks).hasSizeGreaterThan(50).allSatisfy(formula -> {
            Path file = Path.of("src/main/java/cz/paprsek", formula.group(2));
            assertThat(file).exists().content().contains(formula.group(3).translateEscapes());
        });
    }
}
