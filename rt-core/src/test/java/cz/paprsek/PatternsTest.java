package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Patterns mean the same to every Java: since 19 a word ends before an accent, unless the pattern has the flag U. */
class PatternsTest {
    private static final Pattern TEXT = Pattern.compile("\"((?:[^\"\\\\\n]|\\\\.)*+)\"");

    @Test
    void wordsEndWhereTheirLettersDo() throws IOException {
        int asked = 0;
        for (String module : List.of("rt-core", "rt-cli", "rt-fx")) {
            try (Stream<Path> files = Files.walk(Path.of("..", module, "src/main/java"))) {
                for (Path file : files.filter(each -> each.toString().endsWith(".java")).toList()) {
                    for (Matcher text = TEXT.matcher(Files.readString(file)); text.find();) {
                        if (text.group(1).contains("\\\\b(")) {
                            assertThat(text.group(1)).as("%s", file).startsWith("(?U)");
                            asked++;
                        }
                    }
                }
            }
        }
        assertThat(asked).isPositive();
    }

    @Test
    void anAccentIsPartOfAName() {
        assertThat(Pattern.compile("(?U)\\b(t|it)\\b").matcher("měřit, ět").find()).isFalse();
    }
}
