package cz.paprsek.cli;

import cz.paprsek.cli.describe.ModelSummary;
import cz.paprsek.cli.describe.SceneSummary;
import cz.paprsek.cli.describe.SummaryAsJson;
import cz.paprsek.cli.describe.SummaryAsText;
import cz.paprsek.cli.input.ParameterWishes;
import cz.paprsek.cli.input.SceneArguments;
import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Interruption;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.format.ForeignScene;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.mesh.Triangles;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Says what is in scene files. */
@Command(
        name = "info",
        description = "Says what is in scene files and databases: picture, camera, lights, materials, objects by kind, and the space they take; "
                + "and what files of triangles hold: whether they are closed, their volume, area and bounds.",
        footer = {"", "Examples:", "  paprsek info showcase.xml", "  paprsek info 'scenes/*.xml' --json", "  paprsek info part.stl"})
final class InfoCommand implements Callable<Integer> {
    private final Terminal terminal;
    private final Stop stop;

    @Parameters(paramLabel = "SCENE", arity = "1..*",
            description = "Scene files, or - for standard input. Patterns with * ? [] {} and ** are expanded, also when quoted.")
    private List<String> scenes;

    @Option(names = "--json", description = "Prints a JSON object for every scene, one a line, instead of plain text.")
    private boolean json;

    @Mixin
    private ParameterWishes given;

    InfoCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        if (json) {
            stop.oweLastWords();
        }
        int worst = ExitCode.DONE;
        for (Path file : SceneArguments.files(scenes)) {
            SceneReading reading = SceneReading.of(file, given);
            if (stop.requested()) {
                return Interruption.told(terminal, json);
            }
            reading.sentences().forEach(terminal::message);
            if (!json) {
                reading.notes().forEach(terminal::message);
            }
            Optional<Triangles> mesh = reading.foreign().flatMap(ForeignScene::triangles);
            mesh.ifPresent(triangles -> show(file, reading.foreign().orElseThrow(), triangles));
            if (mesh.isEmpty()) {
                reading.whole().forEach(i -> show(file, reading.label(i), reading.scenes().get(i)));
            }
            worst = Math.max(worst, reading.isValid() ? ExitCode.DONE : ExitCode.BAD_SCENE);
        }
        return worst;
    }

    private void show(Path file, ForeignScene model, Triangles mesh) {
        if (json) {
            terminal.result(ModelSummary.json(file.toString(), model, mesh).toString());
        } else {
            terminal.result(file.toString());
            ModelSummary.lines(model, mesh).forEach(terminal::result);
        }
    }

    private void show(Path file, String label, Scene scene) {
        SceneSummary summary = SceneSummary.of(scene);
        if (json) {
            terminal.result(SummaryAsJson.of(file.toString(), summary).toString());
        } else {
            terminal.result(label);
            SummaryAsText.lines(summary).forEach(terminal::result);
        }
    }
}
