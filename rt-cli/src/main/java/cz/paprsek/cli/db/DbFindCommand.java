package cz.paprsek.cli.db;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.query.Column;
import cz.paprsek.query.Filter;
import cz.paprsek.query.FilterException;
import cz.paprsek.query.Relation;
import cz.paprsek.query.SceneTables;
import cz.paprsek.query.Table;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Finds parts of scenes in all tables at once. */
@Command(
        name = "find",
        description = "Finds cameras, lights, materials and objects, operands included, in all tables that have the columns of the filter: "
                + "which table they are in, which scene, and where in the scene.",
        footer = {"", "Examples:", "  paprsek db find my.xml --where 'name like \"%%key%%\"'", "  paprsek db find my.xml --where 'radius > 2'"})
final class DbFindCommand extends DbAction {
    @Parameters(index = "0", paramLabel = "DATABASE", description = "A database file.")
    private Path file;

    @Option(names = "--where", required = true, paramLabel = "FILTER", description = "What to find; 'paprsek db --help' explains filters.")
    private String where;

    @Option(names = "--scenes", paramLabel = "FILTER", description = "Only in scenes that match.")
    private Optional<String> scenes = Optional.empty();

    @Mixin
    private ListingOptions listing;

    /** A row of a table that matches. */
    private record Found(String table, String scene, String path, String name) {}

    /** A table with a filter of its rows. */
    private record Search<R>(Relation<Scene, R> relation, Filter<R> filter) {
        Stream<Found> in(Scene scene) {
            Table<R> table = relation.table();
            return relation.rows().apply(scene).filter(filter)
                    .map(row -> new Found(table.name(), scene.name(), cell(table, "path", row), cell(table, "name", row)));
        }

        private static <R> String cell(Table<R> table, String column, R row) {
            return table.ownColumn(column).map(found -> found.cell(row).text()).orElse("");
        }
    }

    DbFindCommand(Terminal terminal, Stop stop) {
        super(terminal, stop);
    }

    @Override
    void run() {
        var inScenes = filter("--scenes", scenes, SceneTables.SCENE);
        List<Search<?>> searches = searches();
        SceneDatabase database = read(file);
        Table<Found> table = new Table<>("find", List.of(Column.text("table", Found::table), Column.text("scene", Found::scene),
                Column.text("path", Found::path), Column.text("name", Found::name)), List.of());
        listing.print(terminal, table, table.columns(),
                database.scenes().stream().filter(inScenes).flatMap(scene -> searches.stream().flatMap(search -> search.in(scene))));
    }

    /** The tables in which the filter makes sense; if that is none, the complaint of the one that understood most of it or has advice. */
    private List<Search<?>> searches() {
        List<Search<?>> searches = new ArrayList<>();
        List<FilterException> complaints = new ArrayList<>();
        for (Relation<Scene, ?> relation : SceneTables.all()) {
            String table = relation.table().name();
            if (!table.equals("scene") && !table.equals("object")) {
                search(relation, searches, complaints);
            }
        }
        if (searches.isEmpty()) {
            throw new WrongUsage("--where, " + complaints.stream()
                    .max(Comparator.comparingInt(FilterException::position).thenComparing(e -> String.valueOf(e.getMessage()).contains("did you mean")))
                    .orElseThrow().getMessage());
        }
        return searches;
    }

    private <R> void search(Relation<Scene, R> relation, List<Search<?>> searches, List<FilterException> complaints) {
        try {
            searches.add(new Search<>(relation, Filter.parse(where, relation.table())));
        } catch (FilterException e) {
            complaints.add(e);
        }
    }
}
