package cz.paprsek.query;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/** The tables of filters, which the tests of all faces go through. */
final class FilterTable {
    static final Path FOLDER = Path.of("src/test/resources/cz/paprsek/query");

    private FilterTable() {}

    /** The fields of every line; no filter has a bar in it. */
    static List<String[]> lines(String file) throws IOException {
        return Files.readAllLines(FOLDER.resolve(file)).stream()
                .filter(line -> !line.isBlank() && !line.startsWith("#"))
                .map(line -> Arrays.stream(line.split("\\|", -1)).map(String::strip).toArray(String[]::new))
                .toList();
    }
}
