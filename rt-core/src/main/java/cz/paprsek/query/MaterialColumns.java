package cz.paprsek.query;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** What the table of materials and those of objects have in common. */
final class MaterialColumns {
    private MaterialColumns() {}

    static <R> List<Column<R>> of(Function<R, Material> of) {
        List<Column<R>> columns = new ArrayList<>(List.of(
                Column.text("pattern", row -> pattern(of.apply(row))),
                Column.color("color", row -> of.apply(row).pattern() instanceof Pattern.Plain plain ? Optional.of(plain.color()) : Optional.empty())));
        columns.addAll(numbers(Material.class, of));
        return columns;
    }

    /** A column for each number that is an attribute of a record, or one of two that are. */
    static <R, T> List<Column<R>> numbers(Class<T> record, Function<R, T> of) {
        List<Column<R>> columns = new ArrayList<>();
        for (Described one : Described.of(record)) {
            if (one.isNumber()) {
                columns.add(Column.number(one.name(), row -> one.number(of.apply(row))));
            } else if (one.type() == double[].class) {
                for (int i = 0; i < one.components().size(); i++) {
                    int number = i;
                    columns.add(Column.number(Described.name(one.components().get(i)), row -> ((double[]) one.value(of.apply(row)))[number]));
                }
            }
        }
        return columns;
    }

    /** The kind of a material's pattern, as its element in a scene file: {@code checker}; {@code plain} for one colour. */
    private static String pattern(Material material) {
        return ElementTable.name(material.pattern().getClass());
    }
}
