package cz.paprsek.cli;

import cz.paprsek.io.PlainText;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code rt-cli info}. */
@Command(
        name = "info",
        mixinStandardHelpOptions = true,
        description = "Tells what is in scene files: objects by kind, bounds, lights, camera, render settings.")
final class InfoCommand implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Parameters(paramLabel = "SCENE", arity = "1..*", description = "Scene files, or patterns such as 'scenes/*.xml'.")
    private List<String> scenes;

    @Option(names = "--json", description = "Print one JSON object per scene.")
    private boolean json;

    @Override
    public Integer call() {
        int worst = ExitCode.DONE;
        PrintWriter out = spec.commandLine().getOut();
        PrintWriter err = spec.commandLine().getErr();
        try {
            for (Path file : SceneArguments.expand(scenes)) {
                try {
                    Map<String, Object> facts = SceneFacts.of(file, SceneFiles.read(file));
                    if (json) {
                        out.println(Json.of(facts));
                    } else {
                        facts.forEach((name, value) -> out.printf("%-12s %s%n", name, PlainText.of(SceneFacts.text(value), 2000)));
                        out.println();
                    }
                } catch (SceneFileException e) {
                    e.problems().forEach(problem -> err.println(problem));
                    worst = ExitCode.BAD_SCENE;
                } catch (IOException e) {
                    err.println(PlainText.of(String.valueOf(e.getMessage()), 500));
                    worst = ExitCode.BAD_SCENE;
                }
            }
        } catch (IOException e) {
            throw new ParameterException(spec.commandLine(), String.valueOf(e.getMessage()), e);
        }
        return worst;
    }
}
