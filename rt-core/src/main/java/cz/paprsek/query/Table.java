package cz.paprsek.query;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * What rows of a kind have in common.
 *
 * @param <R> the row
 * @param name the table's name
 * @param columns in the order they are shown
 * @param related where a row leads to; columns of those tables serve in a filter too, and stand for all their values
 */
public record Table<R>(String name, List<Column<R>> columns, List<Relation<R, ?>> related) {
    public Table {
        Objects.requireNonNull(name, "name");
        columns = List.copyOf(columns);
        related = List.copyOf(related);
    }

    /** The column that a name in a filter means: one of this table, one of its three numbers ({@code color.red}), or one of a related table. */
    public Optional<Column<R>> column(String called) {
        return ownColumn(called).or(() -> relatedColumn(called));
    }

    /** The related rows of that name. */
    Optional<Relation<R, ?>> relation(String called) {
        return related.stream().filter(relation -> relation.table().name().equalsIgnoreCase(called)).findFirst();
    }

    /** Every name a filter may use, those of three numbers without their parts. */
    Collection<String> names() {
        Set<String> names = new LinkedHashSet<>();
        columns.forEach(column -> names.add(column.name()));
        related.forEach(relation -> relation.table().columns().forEach(column -> names.add(column.name())));
        return names;
    }

    /** One of this table only, or one of its three numbers. */
    public Optional<Column<R>> ownColumn(String called) {
        int dot = called.indexOf('.');
        if (dot >= 0) {
            return ownColumn(called.substring(0, dot)).flatMap(column -> column.part(called.substring(dot + 1)));
        }
        return columns.stream().filter(column -> column.name().equalsIgnoreCase(called)).findFirst();
    }

    /** What parts repeat of the table before them is looked for there alone; other measures may be those of a part and of something else: a radius. */
    private Optional<Column<R>> relatedColumn(String called) {
        List<Column<R>> found = new ArrayList<>();
        boolean isRepeated = false;
        for (Relation<R, ?> relation : related) {
            Optional<Column<R>> column = relation.isPart() && isRepeated ? Optional.empty() : relation.column(called);
            isRepeated = relation.isPart() ? isRepeated : column.isPresent();
            column.filter(one -> found.isEmpty() || one.type() == found.get(0).type()).ifPresent(found::add);
        }
        return found.isEmpty() ? Optional.empty() : Optional.of(new Column<>(found.get(0).name(), found.get(0).type(),
                (row, test) -> found.stream().anyMatch(column -> column.any(row, test))));
    }
}
