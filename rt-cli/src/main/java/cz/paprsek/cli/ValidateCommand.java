package cz.paprsek.cli;

import cz.paprsek.cli.input.ParameterWishes;
import cz.paprsek.cli.input.SceneArguments;
import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Interruption;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.io.Json;
import cz.paprsek.scene.Scene;
import cz.paprsek.warning.SceneWarning;
import cz.paprsek.warning.SceneWarnings;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.Problem;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Checks scene files. */
@Command(
        name = "validate",
        description = {
            "Checks scene files and databases.",
            "Every problem goes to standard error as FILE:LINE:COLUMN: what was expected and what was found.",
            "Warnings go to standard output, likewise with line and column, and do not change the exit code unless --strict is given: materials that give "
                    + "back more light than they get, a camera inside a solid, a light inside an opaque body, an operand that removes nothing, unused "
                    + "materials, glass of several refractive indices or reaching into other glass, or made milky by ambient light, darkness.",
            "Notes are never problems: where bodies of glass touch, which is how water stands in a tumbler."
        },
        footer = {"", "Examples:", "  paprsek validate my.xml", "  paprsek validate 'scenes/**.xml' --json"})
final class ValidateCommand implements Callable<Integer> {
    /** Which of several alike, or of the copies of one: the only thing in which what is said of them differs. */
    private static final Pattern COPY = Pattern.compile("#\\d+|\\[\\d+\\]");

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

    @Mixin
    private ParameterWishes given;

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
            SceneReading reading = SceneReading.of(file, given).withPictures(given.pictures());
            List<Found> all = found(reading);
            List<Found> warnings = all.stream().filter(found -> !found.warning().isNote()).toList();
            List<Found> notes = all.stream().filter(found -> found.warning().isNote()).toList();
            if (stop.requested()) {
                return Interruption.told(terminal, json);
            }
            reading.sentences().forEach(terminal::message);
            if (strict) {
                warnings.forEach(warning -> terminal.message(warning.toString()));
            }
            boolean isGood = reading.isValid() && (warnings.isEmpty() || !strict);
            if (json) {
                terminal.result(json(reading, warnings, notes, isGood));
            } else if (!quiet && isGood) {
                all.forEach(found -> terminal.result(found.toString()));
                terminal.result(file + ": valid" + counted(warnings.size(), "warning") + counted(notes.size(), "note"));
            }
            worst = Math.max(worst, isGood ? ExitCode.DONE : ExitCode.BAD_SCENE);
        }
        return worst;
    }

    private static String counted(int number, String word) {
        return number == 0 ? "" : ", " + number + " " + word + (number == 1 ? "" : "s");
    }

    /**
     * A warning or note on one of the scenes of a file.
     *
     * @param problem what it says, and where
     */
    private record Found(String scene, SceneWarning warning, Problem problem) {
        @Override
        public String toString() {
            return problem.toString();
        }
    }

    /** What is true of several copies, which stand in one place, once. */
    private static List<Found> found(SceneReading reading) {
        Map<String, Found> found = new LinkedHashMap<>();
        reading.text().ifPresent(text -> {
            OriginalText.Pointer pointer = text.pointer();
            for (int i : reading.whole().toArray()) {
                Scene scene = reading.scenes().get(i);
                String where = text.contents().isDatabase() ? "scene \"" + scene.name() + "\": " : "";
                for (SceneWarning warning : SceneWarnings.of(scene)) {
                    String message = (warning.isNote() ? "note: " : "warning: ") + where + warning.message();
                    Problem problem = pointer.at(i, warning.place(), warning.attribute(), message);
                    found.putIfAbsent(COPY.matcher(problem.toString()).replaceAll(""), new Found(scene.name(), warning, problem));
                }
            }
        });
        return List.copyOf(found.values());
    }

    private static String json(SceneReading reading, List<Found> warnings, List<Found> notes, boolean isGood) {
        return new Json()
                .with("file", reading.file().toString())
                .with("valid", isGood)
                .with("problems", reading.problems().stream().map(ValidateCommand::json).toList())
                .with("warnings", warnings.stream().map(ValidateCommand::json).toList())
                .with("notes", notes.stream().map(ValidateCommand::json).toList())
                .toString();
    }

    private static Json json(Found found) {
        return new Json().with("file", found.problem().file()).with("line", found.problem().line()).with("column", found.problem().column())
                .with("scene", found.scene()).with("object", found.warning().object()).with("kind", found.warning().kind())
                .with("message", found.warning().message());
    }

    private static Json json(Problem problem) {
        return new Json().with("file", problem.file()).with("line", problem.line()).with("column", problem.column()).with("message", problem.message());
    }
}
