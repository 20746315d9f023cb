package cz.paprsek.cli.db;

import cz.paprsek.cli.input.Incoming;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Writes a new database. */
@Command(
        name = "init",
        description = "Writes a new database with a test scene and examples of everything that scenes may have.",
        footer = {"", "Example:", "  paprsek db init my.xml && paprsek db list my.xml"})
final class DbInitCommand extends DbAction {
    @Parameters(index = "0", paramLabel = "DATABASE", description = "The file to write.")
    private Path file;

    @Option(names = "--empty", description = "Without any scene.")
    private boolean empty;

    @Option(names = "--force", description = "Overwrites a file that exists.")
    private boolean force;

    DbInitCommand(Terminal terminal, Stop stop) {
        super(terminal, stop);
    }

    @Override
    void run() throws IOException {
        Incoming.requireFile(file);
        if (Files.exists(file) && !force) {
            throw new WrongUsage(file + " exists already; --force overwrites it");
        }
        SceneDatabase content = empty ? SceneDatabase.EMPTY : SceneFiles.examples();
        stop.write(file, () -> SceneFiles.writeAll(content.scenes(), file));
        done(file + ": " + scenes(content.size()));
    }
}
