package cz.paprsek.render;

import cz.paprsek.image.Image;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;

/** One picture under way: its tiles, taken from a counter by any number of workers, and what they have in common. */
final class RenderJob implements RenderMonitor {
    private static final int SIDE = 32;

    private final RenderScene scene;
    private final RenderOptions options;
    private final RenderMonitor monitor;
    private final Image image;
    private final Eye eye;
    private final int columns;
    private final int tiles;
    private final AtomicInteger next = new AtomicInteger();
    private final AtomicInteger done = new AtomicInteger();
    private final AtomicReference<@Nullable RuntimeException> failure = new AtomicReference<>();
    private volatile boolean stopped;
    private RenderStats total = RenderStats.NONE;

    RenderJob(RenderScene scene, RenderOptions options, RenderMonitor monitor) {
        this.scene = scene;
        this.options = options;
        this.monitor = monitor;
        Tile region = options.region();
        image = new Image(region.width(), region.height());
        eye = new Eye(scene.scene().camera(), options.settings().width(), options.settings().height());
        columns = (region.width() + SIDE - 1) / SIDE;
        tiles = columns * ((region.height() + SIDE - 1) / SIDE);
    }

    int tiles() {
        return tiles;
    }

    Image image() {
        return image;
    }

    boolean isComplete() {
        return done.get() == tiles;
    }

    void cancel() {
        stopped = true;
    }

    @Override
    public boolean cancelled() {
        return stopped || monitor.cancelled();
    }

    /** Renders tiles until none is left or the job is stopped. */
    void work() {
        Tracer tracer = new Tracer(scene, options.settings().maxDepth(), this);
        for (int i = next.getAndIncrement(); i < tiles && !cancelled(); i = next.getAndIncrement()) {
            render(tile(i), tracer);
        }
        add(tracer);
    }

    void throwFailure() {
        RuntimeException thrown = failure.get();
        if (thrown != null) {
            throw thrown;
        }
    }

    synchronized RenderStats stats(double buildSeconds, double traceSeconds) {
        return new RenderStats(total.primary(), total.reflected(), total.refracted(), total.shadow(), total.hits(),
                buildSeconds, traceSeconds);
    }

    private synchronized void add(Tracer tracer) {
        total = new RenderStats(total.primary() + tracer.primary, total.reflected() + tracer.reflected,
                total.refracted() + tracer.refracted, total.shadow() + tracer.shadows, total.hits() + tracer.hits, 0, 0);
    }

    private Tile tile(int number) {
        int x = number % columns * SIDE;
        int y = number / columns * SIDE;
        return new Tile(x, y, Math.min(SIDE, image.width() - x), Math.min(SIDE, image.height() - y));
    }

    private void render(Tile tile, Tracer tracer) {
        int x = tile.x();
        int y = tile.y();
        try {
            for (y = tile.y(); y < tile.y() + tile.height(); y++) {
                for (x = tile.x(); x < tile.x() + tile.width(); x++) {
                    render(x, y, tracer);
                    if (tracer.cancelled) {
                        return;
                    }
                }
            }
            monitor.finished(tile, image, done.incrementAndGet(), tiles);
        } catch (RuntimeException | StackOverflowError e) {
            stopped = true;
            failure.compareAndSet(null, new IllegalStateException("rendering failed at pixel " + x + ", " + y + ": " + e, e));
        }
    }

    /** Averages the rays of one pixel: a regular grid, whose middle is the pixel's centre. */
    private void render(int x, int y, Tracer tracer) {
        int side = options.settings().samples();
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int i = 0; i < side; i++) {
            for (int j = 0; j < side; j++) {
                double column = options.region().x() + x + (j + 0.5) / side;
                double row = options.region().y() + y + (i + 0.5) / side;
                Level level = tracer.trace(eye, column, row);
                red += level.red;
                green += level.green;
                blue += level.blue;
            }
        }
        double share = 1.0 / (side * side);
        image.set(x, y, red * share, green * share, blue * share);
    }
}
