package cz.paprsek.cli;

import cz.paprsek.cli.process.Results;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import java.io.ByteArrayOutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;

/** A call of the command line within the test's own process: what it returned and what it printed. */
public record Run(int code, String out, String err, ByteArrayOutputStream written) {

    public static Run cli(Object... arguments) {
        return watched(false, new Stop(), arguments);
    }

    public static Run watched(boolean interactive, Stop stop, Object... arguments) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Terminal terminal = new Terminal(new PrintWriter(out), new PrintWriter(err), new Results(bytes), interactive);
        String[] words = new String[arguments.length];
        for (int i = 0; i < words.length; i++) {
            words[i] = arguments[i].toString();
        }
        int code = new Cli(terminal, stop).run(words);
        return new Run(code, out.toString().replace("\r\n", "\n"), err.toString().replace("\r\n", "\n"), bytes);
    }

    public byte[] bytes() {
        return written.toByteArray();
    }

    public String text() {
        return written.toString(StandardCharsets.UTF_8).replace("\r\n", "\n");
    }
}
