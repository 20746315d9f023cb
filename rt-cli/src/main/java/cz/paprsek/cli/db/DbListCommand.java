package cz.paprsek.cli.db;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.query.Column;
import cz.paprsek.query.SceneTables;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Lists the scenes of a database. */
@Command(
        name = "list",
        description = "Lists the scenes of a database: name, tags, numbers of objects and lights, description.",
        footer = {"", "Examples:", "  paprsek db list my.xml --where 'lights >= 2 and not exists(torus)'", "  paprsek db list my.xml --sort objects --reverse",
            "  paprsek db list my.xml --columns name,width,height --json"})
final class DbListCommand extends DbAction {
    private static final List<String> SHOWN = List.of("name", "tag", "objects", "lights", "description");

    @Parameters(index = "0", paramLabel = "DATABASE", description = "A database file.")
    private Path file;

    @Option(names = "--where", paramLabel = "FILTER", description = "Only scenes that match; 'paprsek db --help' explains filters.")
    private Optional<String> where = Optional.empty();

    @Mixin
    private ListingOptions listing;

    DbListCommand(Terminal terminal, Stop stop) {
        super(terminal, stop);
    }

    @Override
    void run() {
        var filter = filter("--where", where, SceneTables.SCENE);
        SceneDatabase database = read(file);
        List<Column<Scene>> columns = SHOWN.stream().map(name -> SceneTables.SCENE.ownColumn(name).orElseThrow()).toList();
        listing.print(terminal, SceneTables.SCENE, columns, database.scenes().stream().filter(filter));
    }
}
