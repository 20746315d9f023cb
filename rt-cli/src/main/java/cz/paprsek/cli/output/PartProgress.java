package cz.paprsek.cli.output;

import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.shard.Sharing;
import java.util.Locale;

/** How far the share of a picture is, in lines for a log: one every ten seconds. */
final class PartProgress implements Sharing.Listener {
    private static final double SECONDS_BETWEEN = 10;

    private final Terminal terminal;
    private final String label;
    private final boolean silent;
    private final long begin = System.nanoTime();
    private double said;

    /** @param label begins each line */
    PartProgress(Terminal terminal, String label, boolean silent) {
        this.terminal = terminal;
        this.label = label;
        this.silent = silent;
    }

    @Override
    public synchronized void made(int done, int parts) {
        double seconds = (System.nanoTime() - begin) / 1e9;
        if (!silent && done < parts && seconds >= said + SECONDS_BETWEEN) {
            said = seconds;
            terminal.message(String.format(Locale.ROOT, "%s: %d of %d parts after %.0f s", label, done, parts, seconds));
        }
    }
}
