package cz.paprsek.cli;

import cz.paprsek.image.Image;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.Tile;
import java.io.PrintWriter;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import org.jspecify.annotations.Nullable;

/** Tells how far a render is, on standard error: a bar on a terminal, a line now and then elsewhere. */
final class Progress implements RenderMonitor, AutoCloseable {
    private static final long LINE_EVERY_NANOS = 5_000_000_000L;

    private final String name;
    private final PrintWriter err;
    private final boolean bar;
    private final boolean quiet;
    private final Interruption interruption;
    private @Nullable ProgressBar terminal;
    private long nextLine = System.nanoTime() + LINE_EVERY_NANOS;
    private final long begin = System.nanoTime();

    Progress(String name, PrintWriter err, boolean quiet, Interruption interruption) {
        this.name = name;
        this.err = err;
        this.quiet = quiet;
        this.bar = !quiet && Terminal.showsErrors();
        this.interruption = interruption;
    }

    @Override
    public boolean cancelled() {
        return interruption.isRequested();
    }

    @Override
    public synchronized void finished(Tile tile, Image image, int done, int total) {
        if (bar) {
            if (terminal == null) {
                terminal = new ProgressBarBuilder().setTaskName(name).setInitialMax(total).setStyle(ProgressBarStyle.ASCII)
                        .setUpdateIntervalMillis(100).setUnit(" tiles", 1).showSpeed().build();
            }
            terminal.step();
        } else if (!quiet && System.nanoTime() > nextLine && done < total) {
            double elapsed = (System.nanoTime() - begin) / 1e9;
            err.printf("%s: %d %%, %.0f s left%n", name, 100L * done / total, elapsed * (total - done) / done);
            nextLine = System.nanoTime() + LINE_EVERY_NANOS;
        }
    }

    @Override
    public synchronized void close() {
        if (terminal != null) {
            terminal.close();
        }
    }
}
