package cz.paprsek.query;

import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The rows of another table that belong to a row: the lights of a scene.
 *
 * @param <P> the row they belong to
 * @param <R> the rows
 * @param rows finds them; the order is that of the file
 * @param isPart whether another relation has all these rows as well: spheres are objects too
 */
public record Relation<P, R>(Table<R> table, Function<P, Stream<R>> rows, boolean isPart) {
    public Relation {
        Objects.requireNonNull(table, "table");
        Objects.requireNonNull(rows, "rows");
    }


    /** A column of the other table as one of this: its values are those of all rows that belong here. */
    Optional<Column<P>> column(String name) {
        return table.ownColumn(name).map(column -> column.through(rows));
    }
}
