package cz.paprsek.query;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;

/** What the table of materials and those of objects have in common. */
final class MaterialColumns {
    private MaterialColumns() {}

    static <R> List<Column<R>> of(Function<R, Material> of) {
        List<Column<R>> columns = new ArrayList<>(List.of(
                Column.text("pattern", row -> pattern(of.apply(row))),
                Column.color("color", row -> of.apply(row).pattern() instanceof Pattern.Plain plain ? Optional.of(plain.color()) : Optional.empty())));
        columns.addAll(attributes(Material.class, of));
        return columns;
    }

    /** A column for each attribute of a record, whatever its form; two for one of two numbers. */
    static <R, T> List<Column<R>> attributes(Class<T> record, Function<R, T> of) {
        return Described.of(record).stream().flatMap(one -> one.apart().stream()).<Column<R>>map(one -> column(one, row -> one.inForce(of.apply(row)))).toList();
    }

    /** The column of an attribute of one value, of what counts. */
    static <R> Column<R> column(Described one, Function<R, Optional<Object>> of) {
        return switch (one.says().value().form()) {
            case NUMBER, WHOLE, FROM_TO, PAIR -> Column.numbers(one.name(), row -> number(of.apply(row)));
            case VECTOR, SCALE -> Column.vectors(one.name(), row -> of.apply(row).map(Vec3.class::cast));
            case COLOR -> Column.color(one.name(), row -> of.apply(row).map(Rgb.class::cast));
            case WORDS -> Column.texts(one.name(), row -> of.apply(row).stream().flatMap(list -> ((List<?>) list).stream()).map(String::valueOf).toList());
            case WORD -> Column.texts(one.name(), row -> of.apply(row).map(Described::word).stream().toList());
            case TEXT, FLAG -> Column.texts(one.name(), row -> of.apply(row).map(String::valueOf).stream().toList());
        };
    }

    private static OptionalDouble number(Optional<Object> value) {
        return value.isPresent() ? OptionalDouble.of(((Number) value.get()).doubleValue()) : OptionalDouble.empty();
    }

    /** The kind of a material's pattern, as its element in a scene file: {@code checker}; {@code plain} for one colour. */
    private static String pattern(Material material) {
        return ElementTable.name(material.pattern().getClass());
    }
}
