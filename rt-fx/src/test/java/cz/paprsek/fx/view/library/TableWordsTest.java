package cz.paprsek.fx.view.library;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.attribute.Kind;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.query.Column;
import cz.paprsek.query.SceneTables;
import cz.paprsek.query.Value;
import cz.paprsek.scene.Light;
import cz.paprsek.shape.Shape;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What stands in tables, in the language of the window. */
class TableWordsTest {
    private final TableWords words = new TableWords(Texts.in(Locale.forLanguageTag("cs")));

    @Test
    void whateverIsTrueOrFalseIsYesOrNo() {
        Set<String> flags = Stream.concat(Stream.<Class<? extends Record>>of(Material.class), Stream.of(Shape.class, Light.class).flatMap(type -> ElementTable.of(type)))
                .flatMap(type -> Stream.concat(Described.of(type).stream(), Described.inline(type).stream()))
                .filter(one -> one.says().value() == Kind.FLAG).map(Described::name).collect(Collectors.toSet());
        flags.add("hidden");
        List<? extends Column<?>> columns = SceneTables.all().stream().flatMap(relation -> relation.table().columns().stream()).filter(column -> flags.contains(column.name())).toList();
        assertThat(columns).extracting(Column::name).contains("hidden", "smooth", "thin", "visible");
        assertThat(columns).allSatisfy(column -> {
            assertThat(words.cell(column, new Value.Text("true"))).as(column.name()).isEqualTo("ano");
            assertThat(words.cell(column, new Value.Text("false"))).as(column.name()).isEqualTo("ne");
        });
    }

    /** As many digits as the command line shows, and no others. */
    @Test
    void whatAPatternSaysIsRoundedAsEverywhere() {
        Value.Range range = new Value.Range(1.0 / 3, 0.123456, "checker");
        assertThat(range.text()).isEqualTo("0.3333..0.1235 by checker");
        assertThat(words.cell(SceneTables.all().get(0).table().columns().get(0), range)).contains("0,3333").contains("0,1235").doesNotContain("0,33333").doesNotContain("0,12346");
    }
}
