package cz.paprsek.cli;

import cz.paprsek.io.PlainText;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code rt-cli validate}. */
@Command(
        name = "validate",
        mixinStandardHelpOptions = true,
        description = "Tells every problem of scene files, with line and column, and warns of what is allowed but hardly meant.",
        footer = {"", "Problems go to standard error and make the exit code 3; warnings go to standard output and do not."})
final class ValidateCommand implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Parameters(paramLabel = "SCENE", arity = "1..*", description = "Scene files, or patterns such as 'scenes/*.xml'.")
    private List<String> scenes;

    @Override
    public Integer call() {
        PrintWriter out = spec.commandLine().getOut();
        PrintWriter err = spec.commandLine().getErr();
        int worst = ExitCode.DONE;
        try {
            for (Path file : SceneArguments.expand(scenes)) {
                try {
                    List<String> warnings = SceneWarnings.of(SceneFiles.read(file));
                    warnings.forEach(warning -> out.println(file + ": warning: " + PlainText.of(warning, 500)));
                    if (warnings.isEmpty()) {
                        out.println(file + ": ok");
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
