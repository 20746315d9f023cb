package cz.paprsek.cli.process;

import cz.paprsek.io.Json;

/** The end of a command that was asked to stop. */
public final class Interruption {
    private Interruption() {}

    /** Tells whoever reads JSON that there will be no more; returns the exit code. */
    public static int told(Terminal terminal, boolean json) {
        if (json) {
            terminal.result(new Json().with("outcome", "interrupted").toString());
        }
        return ExitCode.INTERRUPTED;
    }
}
