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
import java.util.stream.IntStream;
import java.util.stream.Stream;

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
        return Described.of(record).stream().flatMap(one -> columns(one, of)).toList();
    }

    private static <R, T> Stream<Column<R>> columns(Described one, Function<R, T> of) {
        Function<R, Object> value = row -> one.value(of.apply(row));
        if (one.type() == double[].class) {
            return IntStream.range(0, one.components().size()).mapToObj(i ->
                    Column.number(Described.name(one.components().get(i)), row -> ((double[]) value.apply(row))[i]));
        }
        return Stream.of(switch (one.says().value().form()) {
            case NUMBER, WHOLE -> one.isNumber() ? Column.number(one.name(), row -> one.number(of.apply(row)))
                    : Column.numbers(one.name(), row -> (OptionalDouble) value.apply(row));
            case VECTOR, SCALE -> Column.vector(one.name(), row -> (Vec3) value.apply(row));
            case COLOR -> Column.color(one.name(), row -> Optional.of((Rgb) value.apply(row)));
            case WORDS -> Column.texts(one.name(), row -> ((List<?>) value.apply(row)).stream().map(String::valueOf).toList());
            case WORD -> Column.text(one.name(), row -> Described.word((Enum<?>) value.apply(row)));
            default -> Column.text(one.name(), row -> String.valueOf(value.apply(row)));
        });
    }

    /** The kind of a material's pattern, as its element in a scene file: {@code checker}; {@code plain} for one colour. */
    private static String pattern(Material material) {
        return ElementTable.name(material.pattern().getClass());
    }
}
