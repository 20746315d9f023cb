package cz.paprsek.cli.db;

import cz.paprsek.cli.input.FileNames;
import cz.paprsek.cli.input.Incoming;
import cz.paprsek.cli.input.Originals;
import cz.paprsek.cli.output.Targets;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.io.Failures;
import cz.paprsek.io.Folders;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.SceneFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Writes scenes of a database to files of their own. */
@Command(
        name = "extract",
        description = "Writes scenes of a database to files of their own, their pictures and meshes beside them. Files that exist are not overwritten.",
        footer = {"", "Examples:", "  paprsek db extract my.xml \"Chess set\" -o chess.xml", "  paprsek db extract my.xml --where 'tag = \"glass\"' -o glass/"})
final class DbExtractCommand extends DbAction {
    @Mixin
    private final SceneChoice choice = new SceneChoice();

    @Option(names = {"-o", "--output"}, paramLabel = "FILE|DIR|PATTERN", description = "A file, for one scene; a directory; or a pattern in which {name} "
            + "stands for the scene's name, made fit for a file. - is standard output. Default: {name}.xml in the working directory.")
    private String output = Targets.NAME + ".xml";

    @Option(names = "--force", description = "Overwrites files that exist.")
    private boolean force;

    DbExtractCommand(Terminal terminal, Stop stop) {
        super(terminal, stop);
    }

    @Override
    void run() throws IOException {
        OriginalText text = text(choice.file());
        SceneDatabase database = text.contents().database(Incoming.nameOf(choice.file()));
        List<Scene> scenes = choice.of(database);
        if (output.equals("-") && scenes.size() == 1) {
            try {
                text.alone(scenes.get(0)).writeTo(terminal.bytes());
            } catch (IOException lost) {
                throw new IOException(Failures.sentence("standard output", lost), lost);
            }
            return;
        }
        Map<Path, Scene> files = files(scenes, FileNames.of(database.names()));
        for (Map.Entry<Path, Scene> one : files.entrySet()) {
            stop.guard(() -> {
                takeAlong(choice.file(), List.of(one.getValue()), one.getKey());
                SceneFile.create(one.getKey(), one.getValue(), text);
            });
            done(one.getValue().name() + " -> " + one.getKey());
        }
    }

    private Map<Path, Scene> files(List<Scene> scenes, Map<String, String> fileNames) throws IOException {
        boolean isFolder = output.endsWith("/") || Files.isDirectory(Path.of(output));
        String pattern = isFolder ? (output.endsWith("/") ? output : output + "/") + Targets.NAME + ".xml" : output;
        if (scenes.size() > 1 && !pattern.contains(Targets.NAME)) {
            throw new WrongUsage(scenes.size() + " scenes do not fit into " + output + "; name a directory, or a pattern such as " + Targets.NAME + ".xml");
        }
        Map<Path, Scene> files = new LinkedHashMap<>();
        for (Scene scene : scenes) {
            Path target = Path.of(pattern.replace(Targets.NAME, fileNames.getOrDefault(scene.name(), scene.name())));
            if (Files.exists(target) && !force) {
                throw new WrongUsage(target + " exists already; --force overwrites it");
            }
            files.put(target, scene);
        }
        for (Path target : files.keySet()) {
            Originals.spare(target, "the scene", "the database", List.of(choice.file()));
            Folders.makeFor(target);
        }
        return files;
    }
}
