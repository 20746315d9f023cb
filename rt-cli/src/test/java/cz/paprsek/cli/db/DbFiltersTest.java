package cz.paprsek.cli.db;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Run;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The library's own table of filters, asked on the command line. */
class DbFiltersTest {
    private static final Path FOLDER = Path.of("../rt-core/src/test/resources/cz/paprsek/query");
    private static final Path DATABASE = FOLDER.resolve("filters.xml");
    private static final Map<String, String> SHORT = Map.of("Glass \\\"A\\\"", "G", "Rings", "R", "empty_%", "E",
            "\\u017elu\\u0165ou\\u010dk\\u00fd", "Z");

    private static Stream<String[]> lines(String file) throws IOException {
        return Files.readAllLines(FOLDER.resolve(file)).stream().filter(line -> !line.isBlank() && !line.startsWith("#"))
                .map(line -> Arrays.stream(line.split("\\|", -1)).map(String::strip).toArray(String[]::new));
    }

    static Stream<String[]> filters() throws IOException {
        return lines("filters.txt");
    }

    static Stream<String[]> wrongFilters() throws IOException {
        return lines("wrong-filters.txt");
    }

    @ParameterizedTest
    @MethodSource("filters")
    void aFilterFindsItsRows(String table, String filter, String rows) {
        Run run = Run.cli("db", "show", table, DATABASE, "--where", filter, "--json");
        assertThat(run.err()).isEmpty();
        assertThat(run.code()).isZero();
        assertThat(run.out().lines().map(line -> row(table, line)).collect(Collectors.joining(", "))).isEqualTo(rows);
        if (table.equals("scene")) {
            Run list = Run.cli("db", "list", DATABASE, "--where", filter, "--columns", "name", "--json");
            assertThat(list.out().lines().map(line -> row(table, line)).collect(Collectors.joining(", "))).isEqualTo(rows);
        }
    }

    private static String row(String table, String json) {
        List<String> names = new ArrayList<>();
        for (String member : table.equals("scene") ? List.of("name") : table.equals("camera") ? List.of("scene")
                : List.of("scene", json.contains("\"path\":") ? "path" : "name")) {
            Matcher value = Pattern.compile("\"" + member + "\":\"((?:[^\"\\\\]|\\\\.)*)\"").matcher(json);
            assertThat(value.find()).as(json).isTrue();
            names.add(SHORT.getOrDefault(value.group(1), value.group(1)));
        }
        return String.join("/", names);
    }

    @ParameterizedTest
    @MethodSource("wrongFilters")
    void aWrongFilterSaysWhereAndWhatWasExpected(String table, String filter, String position, String words) {
        Run run = Run.cli("db", "show", table, DATABASE, "--where", filter);
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.out()).isEmpty();
        assertThat(run.err()).startsWith("paprsek: --where, character " + position + ": ").contains(words).hasLineCount(2);
    }
}
