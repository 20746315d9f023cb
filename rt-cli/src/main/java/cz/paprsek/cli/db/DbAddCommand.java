package cz.paprsek.cli.db;

import cz.paprsek.cli.input.Incoming;
import cz.paprsek.cli.input.SceneArguments;
import cz.paprsek.cli.process.BadScene;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.scene.SceneDatabase.Clash;
import cz.paprsek.xml.DatabaseFile;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.SceneFileException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Adds scenes to a database. */
@Command(
        name = "add",
        description = "Adds the scenes of files to a database, which is made if there is none. A scene without a name gets that of its file; pictures and meshes go along.",
        footer = {"", "Examples:", "  paprsek db add my.xml 'scenes/*.xml'", "  paprsek db add my.xml ring.xml --name \"My ring\" --tag csg --tag gold"})
final class DbAddCommand extends DbAction {
    @Parameters(index = "0", paramLabel = "DATABASE", description = "A database file.")
    private Path file;

    @Parameters(index = "1..*", arity = "1..*", paramLabel = "SCENE", description = "Scene files and databases, or - for standard input; patterns are expanded.")
    private List<String> added;

    @Option(names = "--name", paramLabel = "NAME", description = "The name of the scene in the database; for one scene.")
    private Optional<String> name = Optional.empty();

    @Option(names = "--tag", paramLabel = "WORD", description = "Gives the scenes one more tag; may be repeated.")
    private List<String> tags = List.of();

    @Option(names = "--replace", description = "Replaces scenes of the same name. Otherwise they are refused, unless they are the same.")
    private boolean replace;

    DbAddCommand(Terminal terminal, Stop stop) {
        super(terminal, stop);
    }

    @Override
    void run() throws IOException {
        Incoming.requireFile(file);
        Map<Path, OriginalText> texts = new LinkedHashMap<>();
        SceneArguments.files(added).forEach(path -> texts.put(path, text(path)));
        int count = texts.values().stream().mapToInt(text -> text.contents().scenes().size()).sum();
        if (name.isPresent() && count != 1) {
            throw new WrongUsage("--name is for one scene, but there are " + count);
        }
        Gathered more = new Gathered(file, SceneDatabase.EMPTY);
        texts.forEach((path, text) -> more.add(path, labelled(path, text), Clash.REFUSE, "give one of them another name"));
        OriginalText[] from = texts.values().toArray(OriginalText[]::new);
        if (Files.exists(file)) {
            update(file, database -> {
                Gathered all = new Gathered(file, database);
                texts.forEach((path, text) -> all.add(path, labelled(path, text), replace ? Clash.REPLACE : Clash.REFUSE,
                        "--replace takes that of " + path + (count == 1 ? ", --name gives it another name" : "")));
                takeAlong(texts);
                return all.scenes();
            }, from);
        } else {
            stop.write(file, () -> {
                takeAlong(texts);
                create(more.scenes(), from);
            });
        }
        done(file + ": " + scenes(more.scenes().size()) + " added");
    }

    private void takeAlong(Map<Path, OriginalText> texts) throws IOException {
        for (Map.Entry<Path, OriginalText> one : texts.entrySet()) {
            takeAlong(one.getKey(), labelled(one.getKey(), one.getValue()).scenes(), file);
        }
    }

    private void create(SceneDatabase content, OriginalText[] from) throws IOException {
        try {
            DatabaseFile.create(file).save(content, from);
        } catch (SceneFileException e) {
            throw new BadScene(List.of(String.valueOf(e.getMessage())));
        }
    }

    private SceneDatabase labelled(Path path, OriginalText text) {
        List<Scene> found = text.contents().database(Incoming.nameOf(path)).scenes();
        return asked(() -> SceneDatabase.of(found.stream().map(this::labelled).toList()));
    }

    private Scene labelled(Scene scene) {
        Set<String> all = new LinkedHashSet<>(scene.tags());
        all.addAll(tags);
        return scene.withName(name.orElse(scene.name())).withTags(List.copyOf(all));
    }
}
