package cz.paprsek.cli;

import cz.paprsek.cli.describe.SceneWarning;
import cz.paprsek.cli.describe.SceneWarnings;
import cz.paprsek.cli.input.SceneArguments;
import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Interruption;
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
            "Warnings go to standard output and do not change the exit code unless --strict is given: materials that give back more light than they get, a camera "
                    + "inside a solid, a light inside an opaque body, an operand that removes nothing, unused materials, glass of several "
                    + "refractive indices, darkness."
        },
        footer = {"", "Examples:", "  paprsek validate my.xml", "  paprsek validate 'scenes/**.xml' --json"})
final class ValidateCommand implements Callable<Integer> {
    private final Terminal terminal;
    private final Stop stop;

    @Parameters(paramLabel = "SCENE", arity = "1..*",
            description = "Scene files, or - for standard input. Patterns with * ? [] {} and ** are expanded, also when quoted.")
    private List<String> scenes;

    @Option(names = "--strict", description = "Takes warnings for problems: they go to standard error, and the exit code is 3.")
    private boolean strict;

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
        if (json) {
            stop.oweLastWords();
        }
        int worst = ExitCode.DONE;
        for (Path file : SceneArguments.files(scenes)) {
            SceneReading reading = SceneReading.of(file);
            List<Found> warnings = warnings(reading);
            if (stop.requested()) {
                return Interruption.told(terminal, json);
            }
            reading.sentences().forEach(terminal::message);
            if (strict) {
                warnings.forEach(warning -> terminal.message(warning.toString()));
            }
            boolean isGood = reading.isValid() && (warnings.isEmpty() || !strict);
            if (json) {
                terminal.result(json(reading, warnings, isGood));
            } else if (!quiet && isGood) {
                warnings.forEach(warning -> terminal.result(warning.toString()));
                terminal.result(file + ": valid" + (warnings.isEmpty() ? "" : ", " + warnings.size()
                        + (warnings.size() == 1 ? " warning" : " warnings")));
            }
            worst = Math.max(worst, isGood ? ExitCode.DONE : ExitCode.BAD_SCENE);
        }
        return worst;
    }

    /** A warning of one of the scenes of a file. */
    private record Found(String label, String scene, SceneWarning warning) {
        @Override
        public String toString() {
            return label + ": warning: " + warning.message();
        }
    }

    private static List<Found> warnings(SceneReading reading) {
        List<Found> found = new ArrayList<>();
        for (int i = 0; i < reading.scenes().size(); i++) {
            String label = reading.label(i);
            String scene = reading.scenes().get(i).name();
            SceneWarnings.of(reading.scenes().get(i)).forEach(warning -> found.add(new Found(label, scene, warning)));
        }
        return found;
    }

    private static String json(SceneReading reading, List<Found> warnings, boolean isGood) {
        return new Json()
                .with("file", reading.file().toString())
                .with("valid", isGood)
                .with("problems", reading.problems().stream().map(ValidateCommand::json).toList())
                .with("warnings", warnings.stream().map(found -> json(reading.file(), found)).toList())
                .toString();
    }

    private static Json json(Path file, Found found) {
        return new Json().with("file", file.toString()).with("scene", found.scene()).with("object", found.warning().object())
                .with("kind", found.warning().kind()).with("message", found.warning().message());
    }

    private static Json json(Problem problem) {
        return new Json().with("file", problem.file()).with("line", problem.line()).with("column", problem.column()).with("message", problem.message());
    }
}
