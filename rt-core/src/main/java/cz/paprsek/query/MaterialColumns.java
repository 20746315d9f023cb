package cz.paprsek.query;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share.ByPattern;
import cz.paprsek.math.Vec3;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
        Described.of(Material.class).forEach(one -> columns.add(varied(one, of)));
        return columns;
    }

    /** A share may be said by a pattern. */
    private static <R> Column<R> varied(Described one, Function<R, Material> of) {
        Column<R> even = column(one, row -> one.inForce(of.apply(row)));
        return one.says().value() != Kind.SHARE ? even : new Column<>(even.name(), even.type(), (row, test) -> {
            Optional<ByPattern> share = of.apply(row).byPattern(one.name());
            return share.isPresent() ? test.test(Value.Range.of(share.get())) : even.any(row, test);
        });
    }

    /** A column for each attribute of a record, whatever its form; two for one of two numbers. */
    static <R> List<Column<R>> attributes(Class<?> record, Function<R, ?> of) {
        return Described.of(record).stream().flatMap(one -> one.apart().stream()).<Column<R>>map(one -> column(one, row -> one.inForce(of.apply(row)))).toList();
    }

    /** A column for each attribute that records of one of the kinds have in their elements, by its name; empty for those of the others. */
    static <R> Map<String, Column<R>> inline(Class<?> type, Function<R, Object> of) {
        Map<String, Column<R>> columns = new LinkedHashMap<>();
        ElementTable.of(type).flatMap(kind -> Described.inline(kind).stream())
                .forEach(one -> columns.computeIfAbsent(one.name(), name -> column(one, row -> inForce(of.apply(row), name))));
        return columns;
    }

    /** What counts of the attribute of that name, if a record has it. */
    static Optional<Object> inForce(Object record, String name) {
        return Described.inline(record.getClass()).stream().filter(one -> one.name().equals(name)).flatMap(one -> one.inForce(record).stream()).findFirst();
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
