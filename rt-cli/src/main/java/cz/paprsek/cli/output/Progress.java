package cz.paprsek.cli.output;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Tile;
import java.util.function.Supplier;

/** Shows how far a render is, and passes on the user's wish to stop. */
public abstract class Progress implements RenderMonitor, AutoCloseable {
    private final Stop stop;
    private final Pace pace;
    /** Whether pixels end when they are near enough. */
    private final boolean isJudged;
    private final long begin = System.nanoTime();
    private Passed whenPassed = (image, layers, passes) -> true;

    Progress(RenderOptions options, Stop stop) {
        this.stop = stop;
        this.isJudged = options.isInPasses() && options.settings().isAdaptive();
        this.pace = new Pace((long) options.region().width() * options.region().height() * (isJudged ? 1 : options.passes()));
    }

    /** Is told of each pass over a picture that is complete. */
    interface Passed {
        /** Whether to go on. */
        boolean passed(Image image, Supplier<Layers> layers, int passes);
    }

    /** Begins to show the progress of a render. */
    @FunctionalInterface
    public interface Maker {
        /** Shows nothing. */
        Maker SILENT = (scene, options, stop) -> new Progress(options, stop) {
            @Override
            void show(Pace pace, double seconds) {}

            @Override
            void showDenoising(double seconds) {}
        };

        Progress start(String scene, RenderOptions options, Stop stop);
    }

    /** A bar where somebody watches, else a line now and then. */
    public static Maker maker(Terminal terminal) {
        return terminal.interactive()
                ? (scene, options, stop) -> new ProgressBar(terminal, scene, options, stop)
                : (scene, options, stop) -> new ProgressInLines(terminal, scene, options, stop);
    }

    /** Shows how far it is, so many seconds after the beginning; called by one thread at a time. */
    abstract void show(Pace pace, double seconds);

    /** Shows that all is traced, and noise is being taken out. */
    abstract void showDenoising(double seconds);

    @Override
    public final synchronized void denoising() {
        showDenoising(seconds());
    }

    @Override
    public final boolean cancelled() {
        return stop.requested();
    }

    @Override
    public final synchronized void found(Tile tile, Image image, int done, int tiles) {
        if (isJudged) {
            pace.settled((double) done / tiles);
        } else {
            pace.found((long) tile.width() * tile.height());
        }
        refresh();
    }

    @Override
    public final synchronized void finished(Tile tile, Image image, int done, int tiles) {
        if (isJudged) {
            pace.settled((double) done / tiles);
        } else {
            pace.traced((long) tile.width() * tile.height(), seconds());
        }
        refresh();
    }

    @Override
    public final boolean passed(Image image, Supplier<Layers> layers, int passes) {
        return whenPassed.passed(image, layers, passes);
    }

    final void whenPassed(Passed listener) {
        whenPassed = listener;
    }

    final synchronized void refresh() {
        show(pace, seconds());
    }

    private double seconds() {
        return (System.nanoTime() - begin) / 1e9;
    }

    /** Stops showing; the render is over. */
    @Override
    public void close() {}
}
