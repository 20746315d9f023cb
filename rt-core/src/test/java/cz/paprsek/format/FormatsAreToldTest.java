package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Whoever looks for a format finds it wherever formats are listed. */
class FormatsAreToldTest {
    private static final Path ROOT = Path.of("..");

    static Stream<Arguments> places() {
        return Stream.of(Arguments.of("README.md", "| [Other programs' models]", true), Arguments.of("CHANGELOG.md", "- **Other programs' files**", true),
                Arguments.of("docs/scene-file.md", "| `mesh` |", false), Arguments.of("docs/cs/scene-file.md", "| `mesh` |", false),
                Arguments.of("rt-core/src/main/java/cz/paprsek/shape/Mesh.java", "@Attribute(value = Kind.FILE", false));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("places")
    void everyFormatIsNamed(String file, String line, boolean areAll) throws IOException {
        List<String> lines = Files.readAllLines(ROOT.resolve(file));
        assertThat(lines.stream().filter(it -> it.strip().startsWith(line))).singleElement().asString()
                .contains(formats().filter(format -> areAll || format.isMesh()).map(ForeignFormat::word).toList());
    }

    @ParameterizedTest
    @MethodSource("formats")
    void itsRowSaysWhatOfItIsRead(ForeignFormat format) throws IOException {
        Pattern row = Pattern.compile("\\|[^|]*\\b" + format.word() + "\\b[^|]*\\|[^|]+\\|[^|]+\\|[^|]*\\|");
        assertThat(Files.readAllLines(ROOT.resolve("docs/models.md"))).anyMatch(line -> row.matcher(line).matches());
    }

    static Stream<ForeignFormat> formats() {
        return Arrays.stream(ForeignFormat.values());
    }
}
