package cz.paprsek.cli.db;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.query.SceneTables;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** A database, and which of its scenes: those named, or those that match a filter. */
final class SceneChoice {
    @Parameters(index = "0", paramLabel = "DATABASE", description = "A database file.")
    private Path file = Path.of("");

    @Parameters(index = "1..*", arity = "0..*", paramLabel = "NAME", description = "Names of scenes.")
    private List<String> names = List.of();

    @Option(names = "--where", paramLabel = "FILTER", description = "All scenes that match; 'paprsek db --help' explains filters.")
    private Optional<String> where = Optional.empty();

    Path file() {
        return file;
    }

    /** The chosen ones, of names and filter exactly one being given. */
    List<Scene> of(SceneDatabase database) {
        if (names.isEmpty() == where.isEmpty()) {
            throw new WrongUsage("say which scenes: either their names, or --where with a filter");
        }
        if (where.isEmpty()) {
            return names.stream().distinct().map(name -> DbAction.asked(() -> database.get(name))).toList();
        }
        List<Scene> found = database.scenes().stream().filter(DbAction.filter("--where", where, SceneTables.SCENE)).toList();
        if (found.isEmpty()) {
            throw new WrongUsage("no scene matches " + where.get());
        }
        return found;
    }
}
