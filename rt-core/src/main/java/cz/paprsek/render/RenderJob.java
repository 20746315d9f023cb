package cz.paprsek.render;

import cz.paprsek.image.Image;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.Whitted;
import cz.paprsek.render.mode.DepthRange;
import cz.paprsek.render.mode.ModeTracer;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.surface.Level;
import java.math.BigInteger;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;

/** One picture under way: its tiles, taken from a counter by any number of workers, and what they have in common. */
final class RenderJob implements RenderMonitor {
    private static final int SIDE = 32;
    /** Rays along each side of a block, about: how many are traced together. */
    private static final int TOGETHER = 8;
    /** In place of the column and row of a fault outside of any pixel. */
    static final int NOWHERE = -1;

    private final RenderScene scene;
    private final RenderOptions options;
    private final RenderMonitor monitor;
    private final Image image;
    private final Eye eye;
    private final DepthRange depths;
    private final int block;
    private final int columns;
    private final int tiles;
    private final int stride;
    private final AtomicInteger next = new AtomicInteger();
    private final AtomicInteger done = new AtomicInteger();
    private volatile boolean stopped;
    /** What was thrown first, and in what pixel; noted in fields that are there already, because it may be that no memory is left. */
    private @Nullable Throwable fault;
    private int faultColumn = NOWHERE;
    private int faultRow = NOWHERE;
    private RenderStats total = RenderStats.NONE;

    RenderJob(RenderScene scene, RenderOptions options, Eye eye, RenderMonitor monitor) {
        this.scene = scene;
        this.eye = eye;
        this.options = options;
        this.monitor = monitor;
        Tile region = options.region();
        image = new Image(region.width(), region.height());
        depths = options.mode() == RenderMode.DEPTH
                ? DepthRange.of(scene.world(), eye, options.settings().width(), options.settings().height()) : DepthRange.NONE;
        block = Math.max(1, TOGETHER / options.settings().samples());
        columns = (region.width() + SIDE - 1) / SIDE;
        tiles = columns * ((region.height() + SIDE - 1) / SIDE);
        stride = stride(tiles);
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

    /** Renders tiles until none is left or the job is stopped. Whatever is thrown meanwhile is kept for {@link #throwFailure}. */
    void work() {
        try {
            renderTiles();
        } catch (Throwable thrown) {
            fail(thrown, NOWHERE, NOWHERE);
        }
    }

    private void renderTiles() {
        Whitted tracer;
        Blocks blocks;
        if (options.mode() == RenderMode.SHADED) {
            Whitted shading = new Whitted(scene.world(), options.settings().maxDepth(), options.settings().samples(), this::cancelled);
            tracer = shading;
            blocks = (x, y, width, height) -> renderBlock(x, y, width, height, shading);
        } else {
            ModeTracer showing = new ModeTracer(scene.world(), options.mode(), options.settings().maxDepth(), depths, options.numbers(), this::cancelled);
            tracer = showing;
            blocks = (x, y, width, height) -> showBlock(x, y, width, height, showing);
        }
        for (int i = next.getAndIncrement(); i < tiles && !cancelled(); i = next.getAndIncrement()) {
            render(tile(i), tracer, blocks);
        }
        add(tracer);
    }

    /** Stops the job, which has failed; column and row of the pixel, if it was one. Only what is thrown first is kept. */
    void fail(Throwable thrown, int column, int row) {
        stopped = true;
        synchronized (this) {
            if (fault == null) {
                fault = thrown;
                faultColumn = column;
                faultRow = row;
            }
        }
    }

    /** @throws IllegalStateException if a worker or the monitor has thrown something, with that as its cause */
    synchronized void throwFailure() {
        if (fault instanceof OutOfMemoryError exhausted) {
            throw Memory.exceeded(scene.scene(), options, exhausted);
        }
        if (fault != null) {
            String place = faultRow == NOWHERE ? "" : " at pixel " + faultColumn + ", " + faultRow;
            throw new IllegalStateException("rendering failed" + place + ": " + fault, fault);
        }
    }

    synchronized RenderStats stats(double buildSeconds, double traceSeconds) {
        return new RenderStats(total.primary(), total.reflected(), total.refracted(), total.shadow(), total.hits(),
                buildSeconds, traceSeconds);
    }

    private synchronized void add(Whitted tracer) {
        total = new RenderStats(total.primary() + tracer.primary, total.reflected() + tracer.reflected,
                total.refracted() + tracer.refracted, total.shadow() + tracer.shadows, total.hits() + tracer.hits, 0, 0);
    }

    /**
     * From one tile to the next: all over the picture and evenly at any time, so that what has been done tells how long the rest takes.
     *
     * @source Weyl, multiples of the golden ratio; no tile is met twice, since the number of tiles and the stride have no common divisor
     */
    private static int stride(int tiles) {
        int stride = Math.max(1, (int) (tiles * 0.618033988749895));
        while (BigInteger.valueOf(stride).gcd(BigInteger.valueOf(tiles)).intValue() != 1) {
            stride++;
        }
        return stride;
    }

    /** The tile that comes after so many others. */
    private Tile tile(int turn) {
        int number = (int) ((long) turn * stride % tiles);
        int x = number % columns * SIDE;
        int y = number / columns * SIDE;
        return new Tile(x, y, Math.min(SIDE, image.width() - x), Math.min(SIDE, image.height() - y));
    }

    private void render(Tile tile, Whitted tracer, Blocks blocks) {
        int x = tile.x();
        int y = tile.y();
        long raysBefore = tracer.rays();
        try {
            if (monitor.restored(tile, image)) {
                monitor.finished(tile, image, done.incrementAndGet(), tiles);
                return;
            }
            for (y = tile.y(); y < tile.y() + tile.height(); y += block) {
                for (x = tile.x(); x < tile.x() + tile.width(); x += block) {
                    blocks.render(x, y, Math.min(block, tile.x() + tile.width() - x), Math.min(block, tile.y() + tile.height() - y));
                    // Rays that lead to no others ask nobody whether to stop.
                    if (tracer.cancelled || cancelled()) {
                        return;
                    }
                }
            }
            monitor.traced(tracer.rays() - raysBefore);
            monitor.finished(tile, image, done.incrementAndGet(), tiles);
        } catch (Throwable thrown) {
            fail(thrown, x, y);
        }
    }

    /** Renders a block of pixels of the image. */
    @FunctionalInterface
    private interface Blocks {
        void render(int x, int y, int width, int height);
    }

    private void showBlock(int x, int y, int width, int height, ModeTracer tracer) {
        for (int i = 0; i < width * height && !tracer.cancelled; i++) {
            int column = x + i % width;
            int row = y + i / width;
            Level shown = tracer.pixel(eye, options.region().x() + column, options.region().y() + row, options.settings().samples());
            image.set(column, row, shown.red, shown.green, shown.blue);
        }
    }

    /** Renders a block of pixels. Each is the average of a regular grid of rays about its centre. */
    private void renderBlock(int x, int y, int width, int height, Whitted tracer) {
        Level[] rays = tracer.trace(eye, options.region().x() + x, options.region().y() + y, width, height);
        int perPixel = options.settings().samples() * options.settings().samples();
        double share = 1.0 / perPixel;
        for (int i = 0; i < width * height; i++) {
            double red = 0;
            double green = 0;
            double blue = 0;
            for (int j = i * perPixel; j < (i + 1) * perPixel; j++) {
                red += rays[j].red;
                green += rays[j].green;
                blue += rays[j].blue;
            }
            image.set(x + i % width, y + i / width, red * share, green * share, blue * share);
        }
    }
}
