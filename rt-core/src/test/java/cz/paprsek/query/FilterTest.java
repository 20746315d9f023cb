package cz.paprsek.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class FilterTest {
    private static final Map<String, String> SHORT = Map.of("Glass \"A\"", "G", "Rings", "R", "empty_%", "E", "žluťoučký", "Z");

    static Stream<String[]> filters() throws IOException {
        return FilterTable.lines("filters.txt").stream();
    }

    static Stream<String[]> wrongFilters() throws IOException {
        return FilterTable.lines("wrong-filters.txt").stream();
    }

    private static SceneDatabase database() throws Exception {
        return SceneFiles.readDatabase(FilterTable.FOLDER.resolve("filters.xml"));
    }

    @ParameterizedTest
    @MethodSource("filters")
    void aFilterFindsItsRows(String table, String filter, String rows) throws Exception {
        assertThat(String.join(", ", rows(SceneTables.named(table), filter, database()))).isEqualTo(rows);
    }

    /** A filter that names one of two could not tell which. */
    @Test
    void noTwoColumnsOfATableHaveOneName() {
        SceneTables.all().forEach(relation -> assertThat(relation.table().columns()).as(relation.table().name()).extracting(Column::name).doesNotHaveDuplicates());
        assertThat(SceneTables.named("text").table().columns()).extracting(Column::name).contains("depth", "text-depth");
    }

    private static <R> List<String> rows(Relation<Scene, R> relation, String filter, SceneDatabase database) throws FilterException {
        Filter<R> parsed = Filter.parse(filter, relation.table());
        List<String> names = new ArrayList<>();
        database.scenes().stream().flatMap(relation.rows()).filter(parsed).forEach(row -> {
            Map<String, String> cells = new LinkedHashMap<>();
            relation.table().columns().forEach(column -> cells.put(column.name(), column.cell(row).text()));
            String scene = SHORT.get(cells.getOrDefault("scene", cells.get("name")));
            String part = cells.getOrDefault("path", cells.getOrDefault("name", ""));
            names.add(!cells.containsKey("scene") || cells.containsKey("fovy") ? scene : scene + "/" + part);
        });
        return names;
    }

    @ParameterizedTest
    @MethodSource("wrongFilters")
    void aWrongFilterSaysWhereAndWhatWasExpected(String table, String filter, String position, String words) {
        assertThatThrownBy(() -> Filter.parse(filter, SceneTables.named(table).table()))
                .isInstanceOfSatisfying(FilterException.class, e -> assertThat(e.position()).isEqualTo(Integer.parseInt(position)))
                .hasMessageStartingWith("character " + position + ": ")
                .hasMessageContaining(words)
                .message().doesNotContain("\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"(", "not ", "radius in (", "radius = 1 and ", "((((radius = 1) and ", "\"", "(not ("})
    void noTextHoweverLongDoesHarm(String piece) {
        assertThatThrownBy(() -> Filter.parse(piece.repeat(9_900 / piece.length()), SceneTables.named("sphere").table())).isInstanceOf(FilterException.class);
        assertThatThrownBy(() -> Filter.parse(piece.repeat(20_000), SceneTables.named("sphere").table()))
                .isInstanceOf(FilterException.class).hasMessageContaining("at most 10000 characters");
    }

    @Test
    void aHundredParenthesesAreUnderstoodAndMoreAreNot() throws Exception {
        Table<?> table = SceneTables.named("sphere").table();
        assertThat(Filter.parse("(".repeat(100) + "radius = 1" + ")".repeat(100), table)).isNotNull();
        assertThatThrownBy(() -> Filter.parse("(".repeat(101) + "radius = 1" + ")".repeat(101), table)).hasMessageContaining("deeper than 100");
    }

    @Test
    void wordsThrownTogetherAreUnderstoodOrRefused() throws Exception {
        List<String> words = List.of("radius > 1", "name like 'a%'", "exists(torus)", "count(object) >= 2", "radius", "name", "position", "color.red", "tag", "lights", "=", "<", "!=", "like", "in", "not", "and", "or", "(", ")",
                ",", "1", "-2.5e3", "\"a%\"", "'0 1 0'", "exists", "count", "torus", "where", "object", ".", "\"", "€", "\u0000", "𝄞");
        Random random = new Random(5);
        SceneDatabase database = database();
        int understood = 0;
        for (int i = 0; i < 20_000; i++) {
            StringBuilder text = new StringBuilder();
            for (int n = random.nextInt(9); n >= 0; n--) {
                text.append(words.get(random.nextInt(words.size()))).append(random.nextInt(4) == 0 ? "" : " ");
            }
            try {
                Filter<Scene> filter = Filter.parse(text.toString(), SceneTables.SCENE);
                database.scenes().forEach(filter::test);
                understood++;
            } catch (FilterException wrong) {
                assertThat(wrong.position()).isBetween(1, text.length() + 1);
            }
        }
        assertThat(understood).isGreaterThan(100);
    }

    @Test
    void aPatternThatNearlyFitsAgainAndAgainIsNotTriedForEver() throws Exception {
        String text = "a".repeat(5_000);
        Filter<Scene> filter = Filter.parse("description like \"" + "%a".repeat(2_000) + "%b\"", SceneTables.SCENE);
        assertThat(filter.test(Scene.EMPTY.withDescription(text))).isFalse();
        assertThat(filter.test(Scene.EMPTY.withDescription(text + "b"))).isTrue();
    }

    @Test
    void columnsOfOneNameAreOfOneType() {
        Map<String, Column.Type> types = new LinkedHashMap<>();
        for (Relation<Scene, ?> relation : SceneTables.all()) {
            relation.table().columns().forEach(column ->
                    assertThat(types.merge(column.name(), column.type(), (a, b) -> a)).as(column.name()).isEqualTo(column.type()));
        }
        assertThat(types).containsKeys("radius", "semi-axes", "min-x", "operands", "refractive-index");
    }

    @Test
    void everyColumnOfEveryTableCanBeReadOfEveryRow() throws Exception {
        SceneDatabase database = database();
        int cells = 0;
        for (Relation<Scene, ?> relation : SceneTables.all()) {
            cells += cells(relation, database);
        }
        assertThat(cells).isGreaterThan(300);
        assertThat(SceneTables.all().stream().map(relation -> relation.table().name())).contains("scene", "camera", "light", "material", "object",
                "sphere", "block", "ellipsoid", "rectangle", "disc", "plane", "cylinder", "cone", "torus", "capsule", "prism", "superellipsoid", "extrude", "lathe", "text", "isosurface", "height-field", "union", "difference", "intersection");
    }

    private static <R> int cells(Relation<Scene, R> relation, SceneDatabase database) {
        return database.scenes().stream().flatMap(relation.rows())
                .mapToInt(row -> relation.table().columns().stream().mapToInt(column -> column.cell(row).text() == null ? 0 : 1).sum()).sum();
    }

    @Test
    void aTableThatDoesNotExistIsNamedWithItsNeighbour() {
        assertThatThrownBy(() -> SceneTables.named("tours")).hasMessageContaining("there is no table \"tours\"; did you mean \"torus\"?");
        assertThat(Arrays.stream(Column.Type.values()).map(Column.Type::words)).doesNotHaveDuplicates();
    }
}
