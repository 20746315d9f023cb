package cz.paprsek.cli.db;

import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.query.Column;
import cz.paprsek.query.Table;
import cz.paprsek.query.Value;
import cz.paprsek.text.Similar;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine.Option;

/** How a table is to be shown; the options of every command that shows one. */
final class ListingOptions {
    /** Of a text in an aligned table: enough to know what it is about. */
    private static final int WIDEST = 60;

    @Option(names = "--csv", description = "Prints comma-separated values (RFC 4180) with a line of column names.")
    private boolean csv;

    @Option(names = "--json", description = "Prints a JSON object for every row, one a line.")
    private boolean json;

    @Option(names = "--columns", paramLabel = "NAME,...", split = ",", description = "Shows these columns, in this order. Parts of three numbers "
            + "have names such as position.x and color.red.")
    private List<String> columns = List.of();

    @Option(names = "--sort", paramLabel = "COLUMN", description = "Sorts the rows by a column; otherwise they come in the order of the file.")
    private Optional<String> sort = Optional.empty();

    @Option(names = "--reverse", description = "Prints the last row first.")
    private boolean reverse;

    /**
     * Prints rows of a table.
     *
     * @param standard the columns shown if the user names none
     */
    <R> void print(Terminal terminal, Table<R> table, List<Column<R>> standard, Stream<R> rows) {
        print(terminal, table, standard, rows, WIDEST);
    }

    /** As above, texts being cut after so many characters. */
    <R> void print(Terminal terminal, Table<R> table, List<Column<R>> standard, Stream<R> rows, int widest) {
        if (csv && json) {
            throw new WrongUsage("--csv and --json exclude each other");
        }
        List<Column<R>> shown = columns.isEmpty() ? standard : columns.stream().map(name -> column(table, name.strip())).toList();
        Optional<Column<R>> key = sort.map(name -> column(table, name));
        Stream<R> sorted = key.map(column -> rows.sorted(Comparator.comparing(column::cell, Value::compare))).orElse(rows);
        List<R> all = sorted.toList();
        new Listing<>(shown, reverse ? reversed(all) : all, widest).print(terminal, csv ? Listing.Form.CSV : json ? Listing.Form.JSON : Listing.Form.ALIGNED);
    }

    private static <R> Column<R> column(Table<R> table, String name) {
        List<String> known = table.columns().stream().map(Column::name).toList();
        return table.ownColumn(name).orElseThrow(() -> new WrongUsage("there is no column \"" + name + "\" in " + table.name()
                + Similar.choice(name, known)));
    }

    private static <R> List<R> reversed(List<R> rows) {
        List<R> turned = new ArrayList<>(rows);
        Collections.reverse(turned);
        return turned;
    }
}
