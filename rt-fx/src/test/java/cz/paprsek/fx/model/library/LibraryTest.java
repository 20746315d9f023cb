package cz.paprsek.fx.model.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import cz.paprsek.fx.model.Label;
import cz.paprsek.query.Relation;
import cz.paprsek.query.SceneTables;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.DatabaseFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class LibraryTest {
    private static final Path FOLDER = Path.of("../rt-core/src/test/resources/cz/paprsek/query");
    private static final Map<String, String> SHORT = Map.of("Glass \"A\"", "G", "Rings", "R", "empty_%", "E", "žluťoučký", "Z");

    private final Library library = new Library();

    private static Stream<String[]> lines(String file) throws IOException {
        return Files.readAllLines(FOLDER.resolve(file)).stream().filter(line -> !line.isBlank() && !line.startsWith("#"))
                .map(line -> Arrays.stream(line.split("\\|", -1)).map(String::strip).toArray(String[]::new));
    }

    static Stream<String[]> filters() throws IOException {
        return lines("filters.txt");
    }

    static Stream<String[]> wrongFilters() throws IOException {
        return lines("wrong-filters.txt");
    }

    @BeforeEach
    void openTheDatabaseOfTheFilters() throws Exception {
        library.open(DatabaseFile.open(FOLDER.resolve("filters.xml")));
    }

    @ParameterizedTest
    @MethodSource("filters")
    void aFilterFindsItsRows(String table, String filter, String rows) {
        assertThat(rows(SceneTables.named(table), filter)).isEqualTo(rows);
    }

    private <R> String rows(Relation<Scene, R> relation, String filter) {
        try (LibraryRows<R> rows = new LibraryRows<>(library, relation, (column, value) -> "", Runnable::run, Runnable::run)) {
            rows.filterProperty().set(filter);
            assertThat(rows.problemProperty().get()).isEmpty();
            return rows.rows().stream().map(row -> {
                Map<String, String> cells = new LinkedHashMap<>();
                rows.table().columns().forEach(column -> cells.put(column.name(), column.cell(row).text()));
                String scene = SHORT.get(cells.getOrDefault("scene", cells.get("name")));
                return !cells.containsKey("scene") || cells.containsKey("fovy") ? scene
                        : scene + "/" + cells.getOrDefault("path", cells.get("name"));
            }).collect(Collectors.joining(", "));
        }
    }

    @ParameterizedTest
    @MethodSource("wrongFilters")
    void aWrongFilterIsExplainedAndKeepsTheRows(String table, String filter, String position, String words) {
        explained(SceneTables.named(table), filter, "character " + position + ": ", words);
    }

    private <R> void explained(Relation<Scene, R> relation, String filter, String where, String words) {
        try (LibraryRows<R> rows = new LibraryRows<>(library, relation, (column, value) -> "", Runnable::run, Runnable::run)) {
            int before = rows.rows().size();
            rows.filterProperty().set(filter);
            if (!rows.problemProperty().get().isEmpty()) {
                assertThat(rows.problemProperty().get()).startsWith(where).contains(words);
                assertThat(rows.rows()).hasSize(before);
            } else {
                assertThat(filter).as("words alone are looked for").doesNotContainPattern("[=<>()\"']");
            }
        }
    }

    @Test
    void wordsAreLookedForInAllTexts() {
        try (LibraryRows<Scene> rows = new LibraryRows<>(library, SceneTables.scenes(), (column, value) -> "", Runnable::run, Runnable::run)) {
            rows.filterProperty().set("BALL glass");
            assertThat(rows.rows()).extracting(Scene::name).containsExactly("Glass \"A\"");
            rows.filterProperty().set("still");
            assertThat(rows.rows()).extracting(Scene::name).containsExactly("Glass \"A\"", "žluťoučký");
            library.tag(List.of("Rings"), " still  life ");
            assertThat(rows.rows()).hasSize(3);
        }
    }

    @Test
    void everyEditIsAStepThatCanBeUndone() {
        library.rename("Rings", "Two rings");
        assertThat(library.duplicate(List.of("Two rings"))).containsExactly("Two rings 2");
        library.delete(List.of("empty_%", "žluťoučký"));
        assertThat(library.database().names()).containsExactly("Glass \"A\"", "Two rings", "Two rings 2");
        assertThat(library.unsavedProperty().get()).isTrue();
        library.undo();
        library.undo();
        library.undo();
        assertThat(library.unsavedProperty().get()).isFalse();
        assertThat(library.undoableProperty().get()).isEmpty();
        assertThat(library.redoableProperty().get()).contains(Label.of(Label.Edit.RENAME, "Rings"));
        library.redo();
        assertThat(library.database().names()).contains("Two rings");
        assertThatIllegalArgumentException().isThrownBy(() -> library.rename("Two rings", "empty_%"));
    }
}
