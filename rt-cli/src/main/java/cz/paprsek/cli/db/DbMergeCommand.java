package cz.paprsek.cli.db;

import cz.paprsek.cli.input.Incoming;
import cz.paprsek.cli.input.SceneArguments;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase.Clash;
import cz.paprsek.xml.OriginalText;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Takes the scenes of other databases into one. */
@Command(
        name = "merge",
        description = "Takes all scenes of other databases into the first one. Scenes that are the same in both are no clash; different ones of "
                + "the same name are refused, unless you say which to take. Pictures and meshes go along.",
        footer = {"", "Example:", "  paprsek db merge my.xml theirs.xml --keep"})
final class DbMergeCommand extends DbAction {
    @Parameters(index = "0", paramLabel = "DATABASE", description = "The database that gets the scenes.")
    private Path file;

    @Parameters(index = "1..*", arity = "1..*", paramLabel = "OTHER", description = "The databases they are in; patterns are expanded.")
    private List<String> others;

    @Option(names = "--keep", description = "Where names clash, keeps the scene of DATABASE.")
    private boolean keep;

    @Option(names = "--replace", description = "Where names clash, takes the scene of OTHER.")
    private boolean replace;

    DbMergeCommand(Terminal terminal, Stop stop) {
        super(terminal, stop);
    }

    @Override
    void run() throws IOException {
        Incoming.requireFile(file);
        if (keep && replace) {
            throw new WrongUsage("--keep and --replace exclude each other");
        }
        Clash clash = keep ? Clash.KEEP : replace ? Clash.REPLACE : Clash.REFUSE;
        Map<Path, OriginalText> texts = new LinkedHashMap<>();
        SceneArguments.files(others).forEach(other -> texts.put(other, text(other)));
        int[] sizes = new int[2];
        update(file, database -> {
            Gathered all = new Gathered(file, database);
            texts.forEach((other, text) -> all.add(other, text.contents().database(Incoming.nameOf(other)), clash,
                    "--keep takes that of the first, --replace that of the other"));
            for (Map.Entry<Path, OriginalText> one : texts.entrySet()) {
                List<Scene> taken = one.getValue().contents().scenes().stream().filter(scene -> all.scenes().scenes().contains(scene)).toList();
                takeAlong(one.getKey(), taken, file);
            }
            sizes[0] = database.size();
            sizes[1] = all.scenes().size();
            return all.scenes();
        }, texts.values().toArray(OriginalText[]::new));
        done(file + ": " + scenes(sizes[1]) + ", " + (sizes[1] - sizes[0]) + " of them new");
    }
}
