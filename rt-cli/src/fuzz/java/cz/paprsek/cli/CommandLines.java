package cz.paprsek.cli;

import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Results;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import java.io.ByteArrayOutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;

/** Runs commands that must fail, and looks at how. */
public final class CommandLines {
    private CommandLines() {}

    /** @throws AssertionError unless the command ends with the code of a user's mistake and without a stack trace */
    public static void checkRefused(String... arguments) {
        StringWriter err = new StringWriter();
        Terminal terminal = new Terminal(new PrintWriter(new StringWriter()), new PrintWriter(err), new Results(new ByteArrayOutputStream()), false);
        int code = new Cli(terminal, new Stop()).run(arguments);
        if ((code != ExitCode.WRONG_USAGE && code != ExitCode.BAD_SCENE) || err.toString().contains("\tat ")) {
            throw new AssertionError(String.join(" ", arguments) + ": exit code " + code + "\n" + err);
        }
    }
}
