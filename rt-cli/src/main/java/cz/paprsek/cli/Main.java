package cz.paprsek.cli;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;

/** Starts the command line and ends the process with its exit code. */
public final class Main {
    /** How long a process that was told to end waits for its commands to tidy up. */
    private static final long PATIENCE_MILLIS = 5_000;

    private Main() {}

    /** @param args the words after the program's name; {@code --help} explains them */
    public static void main(String[] args) {
        System.setProperty("java.awt.headless", "true");
        Interruption interruption = new Interruption();
        Thread main = Thread.currentThread();
        Runtime.getRuntime().addShutdownHook(new Thread(() -> {
            interruption.request();
            try {
                main.join(PATIENCE_MILLIS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }, "paprsek-tidy-up"));
        PrintWriter out = new PrintWriter(System.out, true, StandardCharsets.UTF_8);
        PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
        int code = new Cli(out, err, interruption).run(args);
        interruption.close();
        if (!interruption.isRequested()) {
            // From a thread of its own: exit waits for the hook, which waits for this one.
            new Thread(() -> System.exit(code), "paprsek-exit").start();
        }
    }
}
