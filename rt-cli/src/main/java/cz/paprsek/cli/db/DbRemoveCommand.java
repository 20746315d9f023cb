package cz.paprsek.cli.db;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** Removes scenes from a database. */
@Command(
        name = "remove",
        description = "Removes scenes from a database, by name or by a filter.",
        footer = {"", "Examples:", "  paprsek db remove my.xml \"Chess set\"", "  paprsek db remove my.xml --where 'tag = \"draft\"'"})
final class DbRemoveCommand extends DbAction {
    @Mixin
    private final SceneChoice choice = new SceneChoice();

    DbRemoveCommand(Terminal terminal, Stop stop) {
        super(terminal, stop);
    }

    @Override
    void run() throws IOException {
        List<String> removed = new ArrayList<>();
        update(choice.file(), database -> {
            removed.addAll(choice.of(database).stream().map(Scene::name).toList());
            return database.without(removed);
        });
        done(choice.file() + ": " + scenes(removed.size()) + " removed: " + String.join(", ", removed));
    }
}
