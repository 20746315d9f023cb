package cz.paprsek.cli.db;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Removes scenes from a database. */
@Command(
        name = "remove",
        description = "Removes scenes from a database, by name or by a filter.",
        footer = {"", "Examples:", "  paprsek db remove my.xml \"Chess set\"", "  paprsek db remove my.xml --where 'tag = \"draft\"'"})
final class DbRemoveCommand extends DbAction {
    @Parameters(index = "0", paramLabel = "DATABASE", description = "A database file.")
    private Path file;

    @Parameters(index = "1..*", arity = "0..*", paramLabel = "NAME", description = "Names of scenes.")
    private List<String> names = List.of();

    @Option(names = "--where", paramLabel = "FILTER", description = "All scenes that match; 'paprsek db --help' explains filters.")
    private Optional<String> where = Optional.empty();

    DbRemoveCommand(Terminal terminal, Stop stop) {
        super(terminal, stop);
    }

    @Override
    void run() throws IOException {
        List<String> removed = new ArrayList<>();
        update(file, database -> {
            removed.addAll(chosen(database, names, where).stream().map(Scene::name).toList());
            return database.without(removed);
        });
        done(file + ": " + scenes(removed.size()) + " removed: " + String.join(", ", removed));
    }
}
