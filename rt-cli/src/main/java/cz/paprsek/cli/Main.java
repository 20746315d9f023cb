package cz.paprsek.cli;

import cz.paprsek.cli.process.Messages;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import java.util.Locale;

/** Where the process begins, and the only place where it ends. */
public final class Main {
    private Main() {}

    /** Runs the command that the arguments say and exits with its code. */
    public static void main(String[] args) {
        // Pictures need parts of AWT, but never a display; looking for one takes time and can fail.
        System.setProperty("java.awt.headless", "true");
        // Numbers in digits that shells and other programs read, whatever the system writes.
        Locale.setDefault(Locale.Category.FORMAT, Locale.ROOT);
        Messages.restore();
        Stop stop = new Stop();
        Runtime.getRuntime().addShutdownHook(new Thread(stop::requestAndWait, "paprsek-stop"));
        int code = new Cli(Terminal.system(), stop).run(args);
        stop.ended();
        System.exit(code);
    }
}
