package cz.paprsek.cli.db;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.query.Filter;
import cz.paprsek.query.Relation;
import cz.paprsek.query.SceneTables;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Predicate;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Shows a table of a database. */
@Command(
        name = "show",
        description = "Shows a table of a database: scene, camera, light, material, object, or the objects of one kind, such as sphere. Operands of "
                + "union, difference and intersection are objects too; their path says where they are, and their depth is above 0.",
        footer = {"", "Examples:", "  paprsek db show material my.xml --where 'transparency > 0'",
            "  paprsek db show sphere my.xml --scenes 'tag = \"glass\"' --columns path,radius"})
final class DbShowCommand extends DbAction {
    @Parameters(index = "0", paramLabel = "TABLE", description = "The name of a table; 'paprsek db tables' lists them.")
    private String table;

    @Parameters(index = "1", paramLabel = "DATABASE", description = "A database file.")
    private Path file;

    @Option(names = "--where", paramLabel = "FILTER", description = "Only rows that match; 'paprsek db --help' explains filters.")
    private Optional<String> where = Optional.empty();

    @Option(names = "--scenes", paramLabel = "FILTER", description = "Only rows of scenes that match.")
    private Optional<String> scenes = Optional.empty();

    @Mixin
    private ListingOptions listing;

    DbShowCommand(Terminal terminal, Stop stop) {
        super(terminal, stop);
    }

    @Override
    void run() {
        show(asked(() -> SceneTables.named(table)), filter("--scenes", scenes, SceneTables.SCENE));
    }

    private <R> void show(Relation<Scene, R> relation, Predicate<Scene> inScenes) {
        Filter<R> filter = filter("--where", where, relation.table());
        SceneDatabase database = read(file);
        listing.print(terminal, relation.table(), relation.table().columns(),
                database.scenes().stream().filter(inScenes).flatMap(relation.rows()).filter(filter));
    }
}
