package cz.paprsek.cli.db;

import cz.paprsek.cli.process.Terminal;
import cz.paprsek.io.PlainText;
import cz.paprsek.query.Column;
import cz.paprsek.query.Value;
import cz.paprsek.query.text.TableText;
import cz.paprsek.text.Numbers;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * Rows of a table as text. Written as it goes: a table may have a million rows.
 *
 * @param columns what is shown of every row
 * @param widest how many characters of a text an aligned table shows; all else is for programs and whole
 */
record Listing<R>(List<Column<R>> columns, List<R> rows, int widest) {

    /** The forms that a table may have. */
    enum Form { ALIGNED, CSV, JSON }

    void print(Terminal terminal, Form form) {
        PrintWriter out = form == Form.CSV ? terminal.table() : terminal.out();
        switch (form) {
            case ALIGNED -> aligned(out);
            case CSV -> csv(out);
            case JSON -> TableText.json(columns, rows).forEach(out::print);
        }
        out.flush();
    }

    /** Columns of equal width, numbers to the right; columns that are empty in every row are left out. */
    private void aligned(PrintWriter out) {
        List<Column<R>> filled = columns.stream()
                .filter(column -> rows.isEmpty() || rows.stream().anyMatch(row -> !column.cell(row).text().isEmpty())).toList();
        int[] widths = filled.stream().mapToInt(column ->
                Math.max(column.name().length(), rows.stream().mapToInt(row -> length(cell(column, row))).max().orElse(0))).toArray();
        StringBuilder head = new StringBuilder();
        for (int i = 0; i < widths.length; i++) {
            pad(head, filled.get(i).name(), widths[i], isRight(filled.get(i)));
        }
        out.println(head.toString().stripTrailing());
        for (R row : rows) {
            StringBuilder line = new StringBuilder();
            for (int i = 0; i < widths.length; i++) {
                pad(line, cell(filled.get(i), row), widths[i], isRight(filled.get(i)));
            }
            out.println(line.toString().stripTrailing());
        }
    }

    private static boolean isRight(Column<?> column) {
        return column.type() == Column.Type.NUMBER;
    }

    private String cell(Column<R> column, R row) {
        Value value = column.cell(row);
        // Nobody reads seventeen digits in a table; programs get them.
        String text = value instanceof Value.Scalar number ? shortened(number.value()) : value.text().strip().replaceAll("\\s+", " ");
        return PlainText.of(text, widest);
    }

    private static String shortened(double number) {
        String exact = Numbers.text(number);
        return exact.length() <= 8 ? exact : Numbers.text(Double.parseDouble(String.format(Locale.ROOT, "%.6g", number)));
    }

    private static int length(String text) {
        return text.codePointCount(0, text.length());
    }

    private static void pad(StringBuilder line, String text, int width, boolean isRight) {
        String blanks = " ".repeat(width - length(text));
        line.append(line.length() == 0 ? "" : "  ").append(isRight ? blanks + text : text + blanks);
    }

    private void csv(PrintWriter out) {
        TableText.csv(columns, rows).forEach(line -> out.print(plain(line)));
    }

    /** The line without anything that a terminal would obey, but for line breaks and tabs. */
    private static String plain(String line) {
        if (line.chars().allMatch(c -> (c >= ' ' && c <= '~') || c == '\r' || c == '\n')) {
            return line;
        }
        return line.codePoints().mapToObj(c -> c == '\r' || c == '\n' || c == '\t' || PlainText.isPlain(c)
                ? Character.toString(c) : String.format("\\u%04x", c)).collect(Collectors.joining());
    }
}
