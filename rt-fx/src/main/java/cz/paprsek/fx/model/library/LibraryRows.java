package cz.paprsek.fx.model.library;

import cz.paprsek.query.Column;
import cz.paprsek.query.Filter;
import cz.paprsek.query.FilterException;
import cz.paprsek.query.Relation;
import cz.paprsek.query.Table;
import cz.paprsek.query.Value;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.property.SimpleStringProperty;
import javafx.beans.property.StringProperty;
import javafx.util.Subscription;

/**
 * The rows of a table that match what is typed, in order: a filter of the filter language, or words, which are looked for in all texts of a
 * row, as files have them and as they are shown. They are found on another thread; there may be a million.
 *
 * @param <R> the row
 */
public final class LibraryRows<R> implements AutoCloseable {
    /** What words alone do not have. */
    private static final Pattern FILTER = Pattern.compile("(?U)[=<>()\"']|\\b(like|in|not)\\b", Pattern.CASE_INSENSITIVE);

    private final Library library;
    private final Relation<Scene, R> relation;
    private final BiFunction<Column<R>, Value, String> shown;
    private final Executor background;
    private final Executor foreground;
    private final ReadOnlyObjectWrapper<List<R>> rows = new ReadOnlyObjectWrapper<>(List.of());
    private final StringProperty filter = new SimpleStringProperty("");
    private final ReadOnlyStringWrapper problem = new ReadOnlyStringWrapper("");
    private final Subscription subscription;
    private List<Order<R>> order = List.of();
    /** The number of the last search; an earlier one has become needless. */
    private final AtomicInteger search = new AtomicInteger();

    /** What rows are sorted by. */
    public record Order<R>(Column<R> column, boolean isAscending) {}

    /**
     * The rows of a table of the database that is open.
     *
     * @param shown what the user reads in a cell, on any thread
     * @param background runs one task after the other
     * @param foreground runs tasks on JavaFX's thread
     */
    public LibraryRows(Library library, Relation<Scene, R> relation, BiFunction<Column<R>, Value, String> shown, Executor background, Executor foreground) {
        this.library = library;
        this.relation = relation;
        this.shown = shown;
        this.background = background;
        this.foreground = foreground;
        subscription = Subscription.combine(library.databaseProperty().subscribe(database -> update()), filter.subscribe(typed -> update()));
    }

    /** Follows the database no longer. */
    @Override
    public void close() {
        subscription.unsubscribe();
        search.incrementAndGet();
    }

    public Table<R> table() {
        return relation.table();
    }

    /** The rows that match; while the filter is wrong, those that matched before. */
    public List<R> rows() {
        return rows.get();
    }

    public ReadOnlyObjectProperty<List<R>> rowsProperty() {
        return rows.getReadOnlyProperty();
    }

    /** What is typed. */
    public StringProperty filterProperty() {
        return filter;
    }

    /** What is wrong with the filter; empty if nothing is. */
    public ReadOnlyStringProperty problemProperty() {
        return problem.getReadOnlyProperty();
    }

    /** Sorts the rows, by the first first; they are in the order of the file if there is none. */
    public void sort(List<Order<R>> by) {
        if (!by.equals(order)) {
            order = List.copyOf(by);
            update();
        }
    }

    private void update() {
        int mine = search.incrementAndGet();
        Predicate<R> matching;
        try {
            matching = matching(filter.get());
            problem.set("");
        } catch (FilterException e) {
            problem.set(String.valueOf(e.getMessage()));
            return;
        }
        SceneDatabase database = library.database();
        List<Order<R>> by = order;
        background.execute(() -> {
            if (mine != search.get()) {
                return;
            }
            List<R> found = sorted(database.scenes().stream().takeWhile(scene -> mine == search.get()).flatMap(relation.rows()).filter(matching), by);
            foreground.execute(() -> {
                if (mine == search.get()) {
                    rows.set(found);
                }
            });
        });
    }

    /** Every value that is compared is read but once. */
    private static <R> List<R> sorted(Stream<R> rows, List<Order<R>> by) {
        if (by.isEmpty()) {
            return rows.toList();
        }
        record Keyed<R>(R row, List<Value> keys) {}

        List<Keyed<R>> keyed = new ArrayList<>(rows.map(row -> new Keyed<>(row, by.stream().map(each -> each.column().cell(row)).toList())).toList());
        keyed.sort((a, b) -> {
            int compared = 0;
            for (int i = 0; compared == 0 && i < by.size(); i++) {
                compared = Value.compare(a.keys().get(i), b.keys().get(i)) * (by.get(i).isAscending() ? 1 : -1);
            }
            return compared;
        });
        return keyed.stream().map(Keyed::row).toList();
    }

    private Predicate<R> matching(String typed) throws FilterException {
        if (typed.isBlank() || FILTER.matcher(typed).find()) {
            return Filter.parse(typed, table());
        }
        List<String> words = Arrays.asList(typed.strip().toLowerCase(Locale.ROOT).split("\\s+", -1));
        List<Column<R>> texts = table().columns().stream().filter(column -> column.type() == Column.Type.TEXT).toList();
        return row -> {
            String all = texts.stream().map(column -> words(column, column.cell(row))).collect(Collectors.joining("\n")).toLowerCase(Locale.ROOT);
            return words.stream().allMatch(all::contains);
        };
    }

    private String words(Column<R> column, Value cell) {
        return cell.text() + "\n" + shown.apply(column, cell);
    }
}
