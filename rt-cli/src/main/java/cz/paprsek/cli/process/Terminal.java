package cz.paprsek.cli.process;

import cz.paprsek.io.PlainText;
import java.io.Console;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Where a command writes. What passes through {@link #result} and {@link #message} is made fit for a
 * terminal.
 *
 * @param out results
 * @param err messages and progress
 * @param bytes standard output once more, for what is not lines of text
 * @param interactive whether somebody watches the messages on a terminal
 */
public record Terminal(PrintWriter out, PrintWriter err, Results bytes, boolean interactive) {

    /** The process's own streams. */
    public static Terminal system() {
        Charset charset = charset();
        Results results = new Results(new FileOutputStream(FileDescriptor.out));
        return new Terminal(new PrintWriter(results.lines(), false, charset), new PrintWriter(System.err, true, charset), results, isWatched(Messages.descriptor()));
    }

    /** Prints a line of results. */
    public void result(String line) {
        out.println(PlainText.of(line, Integer.MAX_VALUE));
        out.flush();
    }

    /** Prints a line for the user. */
    public void message(String line) {
        err.println(PlainText.of(line, Integer.MAX_VALUE));
        err.flush();
    }

    /** Results for other programs to read: always UTF-8. */
    public PrintWriter table() {
        out.flush();
        return new PrintWriter(new OutputStreamWriter(bytes.lines(), StandardCharsets.UTF_8));
    }

    /** The letters that the process's own standard output can show. */
    public static Charset charset() {
        // Known from JDK 19 on; before, it is the default.
        return Charset.forName(System.getProperty("stdout.encoding", Charset.defaultCharset().name()));
    }

    /** Whether somebody watches the results on a terminal of the process's own. */
    public static boolean resultsAreWatched() {
        return isWatched(1);
    }

    /** A stream by itself where the system can tell; otherwise, what Java knows about all streams together. */
    private static boolean isWatched(int descriptor) {
        if ("dumb".equals(System.getenv("TERM"))) {
            return false;
        }
        try {
            String device = Files.readSymbolicLink(Path.of("/proc/self/fd/" + descriptor)).toString();
            return device.startsWith("/dev/pts/") || device.startsWith("/dev/tty") || device.equals("/dev/console");
        } catch (IOException | UnsupportedOperationException noSuchLinks) {
            return consoleIsTerminal();
        }
    }

    /** From JDK 22 on there may be a console without a terminal, and a method that tells; before, there is neither. */
    @SuppressWarnings("SystemConsoleNull")
    private static boolean consoleIsTerminal() {
        Console console = System.console();
        if (console == null) {
            return false;
        }
        try {
            return (Boolean) Console.class.getMethod("isTerminal").invoke(console);
        } catch (ReflectiveOperationException before22) {
            return true;
        }
    }
}
