package cz.paprsek.cli.output;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.image.Image;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Tile;

/** Shows how far a render is, and passes on the user's wish to stop. */
public abstract class Progress implements RenderMonitor, AutoCloseable {
    private final Stop stop;
    private final long total;
    private long pixels;

    Progress(RenderOptions options, Stop stop) {
        this.stop = stop;
        this.total = (long) options.region().width() * options.region().height();
    }

    /** Begins to show the progress of a render. */
    @FunctionalInterface
    public interface Maker {
        /** Shows nothing. */
        Maker SILENT = (scene, options, stop) -> new Progress(options, stop) {
            @Override
            void show(long done, long total) {}
        };

        Progress start(String scene, RenderOptions options, Stop stop);
    }

    /** A bar where somebody watches, else a line now and then. */
    public static Maker maker(Terminal terminal) {
        return terminal.interactive()
                ? (scene, options, stop) -> new ProgressBar(terminal, scene, options, stop)
                : (scene, options, stop) -> new ProgressInLines(terminal, scene, options, stop);
    }

    /** Shows that so many of the picture's pixels are done; called by one thread at a time. */
    abstract void show(long done, long total);

    @Override
    public final boolean cancelled() {
        return stop.requested();
    }

    @Override
    public final void finished(Tile tile, Image image, int done, int tiles) {
        synchronized (this) {
            pixels += (long) tile.width() * tile.height();
            show(pixels, total);
        }
    }

    /** Stops showing; the render is over. */
    @Override
    public void close() {}
}
