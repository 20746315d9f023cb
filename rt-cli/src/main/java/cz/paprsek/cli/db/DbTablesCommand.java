package cz.paprsek.cli.db;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.query.Column;
import cz.paprsek.query.Relation;
import cz.paprsek.query.SceneTables;
import cz.paprsek.query.Table;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** Lists the tables that a database is seen as. */
@Command(
        name = "tables",
        description = "Lists the tables that a database is seen as, with the number of their rows and the names of their columns.",
        footer = {"", "Example:", "  paprsek db tables my.xml --columns table,rows"})
final class DbTablesCommand extends DbAction {
    @Parameters(index = "0", paramLabel = "DATABASE", description = "A database file.")
    private Path file;

    @Mixin
    private ListingOptions listing;

    DbTablesCommand(Terminal terminal, Stop stop) {
        super(terminal, stop);
    }

    @Override
    void run() {
        SceneDatabase database = read(file);
        Table<Relation<Scene, ?>> tables = new Table<>("tables", List.of(
                Column.text("table", relation -> relation.table().name()),
                Column.number("rows", relation -> database.scenes().stream().mapToLong(scene -> relation.rows().apply(scene).count()).sum()),
                Column.texts("columns", relation -> relation.table().columns().stream().map(Column::name).toList())), List.of());
        listing.print(terminal, tables, tables.columns(), SceneTables.all().stream(), Integer.MAX_VALUE);
    }
}
