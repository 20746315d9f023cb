package cz.paprsek.query;

import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;

/** What the table of materials and those of objects have in common. */
final class MaterialColumns {
    private MaterialColumns() {}

    static <R> List<Column<R>> of(Function<R, Material> of) {
        return List.of(
                Column.text("pattern", row -> pattern(of.apply(row))),
                Column.color("color", row -> of.apply(row).pattern() instanceof Pattern.Plain plain ? Optional.of(plain.color()) : Optional.empty()),
                Column.number("diffusion", row -> of.apply(row).diffusion()),
                Column.number("specular", row -> of.apply(row).specular()),
                Column.number("shininess", row -> of.apply(row).shininess()),
                Column.number("reflection", row -> of.apply(row).reflection()),
                Column.number("transparency", row -> of.apply(row).transparency()),
                Column.number("refractive-index", row -> of.apply(row).refractiveIndex()));
    }

    /** The kind of a material's pattern, as its element in a scene file: {@code checker}; {@code plain} for one colour. */
    private static String pattern(Material material) {
        return material.pattern().getClass().getSimpleName().toLowerCase(Locale.ROOT);
    }
}
