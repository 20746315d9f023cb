package cz.paprsek.cli.db;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import java.io.IOException;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Renames a scene of a database. */
@Command(
        name = "rename",
        description = "Gives a scene of a database another name.",
        footer = {"", "Example:", "  paprsek db rename my.xml \"Chess set\" Chess"})
final class DbRenameCommand extends DbAction {
    @Parameters(index = "0", paramLabel = "DATABASE", description = "A database file.")
    private Path file;

    @Parameters(index = "1", paramLabel = "NAME", description = "The scene's name.")
    private String name;

    @Parameters(index = "2", paramLabel = "NEW-NAME", description = "The name it is to have.")
    private String newName;

    DbRenameCommand(Terminal terminal, Stop stop) {
        super(terminal, stop);
    }

    @Override
    void run() throws IOException {
        update(file, database -> database.rename(name, newName));
        done(file + ": \"" + name + "\" is now \"" + newName + "\"");
    }
}
