package cz.paprsek.cli;

import cz.paprsek.cli.describe.SceneWarnings;
import cz.paprsek.cli.input.SceneArguments;
import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.io.Json;
import cz.paprsek.xml.Problem;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Checks scene files. */
@Command(
        name = "validate",
        description = {
            "Checks scene files and databases.",
            "Every problem goes to standard error as FILE:LINE:COLUMN: what was expected and what was found.",
            "Warnings go to standard output and do not change the exit code: materials that give back more light than they get, a camera "
                    + "inside a solid, a light inside an opaque body, an operand that removes nothing, unused materials, glass of several "
                    + "refractive indices, darkness."
        },
        footer = {"", "Examples:", "  rt-cli validate my.xml", "  rt-cli validate 'scenes/**.xml' --json"})
final class ValidateCommand implements Callable<Integer> {
    private final Terminal terminal;
    private final Stop stop;

    @Parameters(paramLabel = "SCENE", arity = "1..*",
            description = "Scene files. Patterns with * ? [] {} and ** are expanded, also when quoted.")
    private List<String> scenes;

    @Option(names = "--json", description = "Prints a JSON object for every file, one a line, instead of plain text.")
    private boolean json;

    @Option(names = {"-q", "--quiet"}, description = "Prints problems only, and what --json asks for.")
    private boolean quiet;

    ValidateCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        int worst = ExitCode.DONE;
        for (Path file : SceneArguments.files(scenes)) {
            SceneReading reading = SceneReading.of(file);
            if (stop.requested()) {
                return ExitCode.INTERRUPTED;
            }
            List<String> warnings = warnings(reading);
            reading.sentences().forEach(terminal::message);
            if (json) {
                terminal.result(json(reading, warnings));
            } else if (!quiet && reading.isValid()) {
                warnings.forEach(terminal::result);
                terminal.result(file + ": valid" + (warnings.isEmpty() ? "" : ", " + warnings.size()
                        + (warnings.size() == 1 ? " warning" : " warnings")));
            }
            worst = Math.max(worst, reading.isValid() ? ExitCode.DONE : ExitCode.BAD_SCENE);
        }
        return worst;
    }

    private static List<String> warnings(SceneReading reading) {
        List<String> warnings = new ArrayList<>();
        for (int i = 0; i < reading.scenes().size(); i++) {
            String label = reading.label(i);
            SceneWarnings.of(reading.scenes().get(i)).forEach(sentence -> warnings.add(label + ": warning: " + sentence));
        }
        return warnings;
    }

    private static String json(SceneReading reading, List<String> warnings) {
        return new Json()
                .with("file", reading.file().toString())
                .with("valid", reading.isValid())
                .with("problems", reading.problems().stream().map(ValidateCommand::json).toList())
                .withTexts("warnings", warnings)
                .toString();
    }

    private static Json json(Problem problem) {
        return new Json().with("line", problem.line()).with("column", problem.column()).with("message", problem.message());
    }
}
