package cz.paprsek.query.text;

import cz.paprsek.io.Json;
import cz.paprsek.query.Column;
import cz.paprsek.query.Value;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Rows of a table as text for other programs, line by line as they are asked for: a table may have a million rows. */
public final class TableText {
    private TableText() {}

    /**
     * Comma-separated values: a line of column names and one for each row, each with its line break.
     *
     * @source RFC 4180
     */
    public static <R> Stream<String> csv(List<Column<R>> columns, List<R> rows) {
        return Stream.concat(Stream.of(line(columns.stream().map(Column::name))),
                rows.stream().map(row -> line(columns.stream().map(column -> column.cell(row).text()))));
    }

    /** A JSON object for each row, in a line of its own, with a member for every column that has a value. */
    public static <R> Stream<String> json(List<Column<R>> columns, List<R> rows) {
        Objects.requireNonNull(columns, "columns");
        return rows.stream().map(row -> json(columns, row) + "\n");
    }

    private static <R> Json json(List<Column<R>> columns, R row) {
        Json json = new Json();
        for (Column<R> column : columns) {
            Value value = column.cell(row);
            if (value instanceof Value.Scalar number) {
                json.with(column.name(), number.value());
            } else if (value instanceof Value.Range range) {
                json.with(column.name(), json(range));
            } else if (value instanceof Value.Triple triple) {
                json.with(column.name(), triple.numbers());
            } else if (value instanceof Value.Text text) {
                json.with(column.name(), text.text());
            }
        }
        return json;
    }

    /** What a pattern says, for programs: the smallest number, the greatest, and the pattern's kind. */
    public static Json json(Value.Range range) {
        return new Json().with("least", range.least()).with("most", range.most()).with("pattern", range.pattern());
    }

    private static String line(Stream<String> fields) {
        return fields.map(TableText::quoted).collect(Collectors.joining(",", "", "\r\n"));
    }

    private static String quoted(String text) {
        boolean needsQuotes = text.chars().anyMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
        return needsQuotes ? "\"" + text.replace("\"", "\"\"") + "\"" : text;
    }
}
