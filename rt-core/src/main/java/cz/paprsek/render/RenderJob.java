package cz.paprsek.render;

import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import cz.paprsek.math.Require;
import cz.paprsek.render.denoise.Denoiser;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.integrate.Exposure;
import cz.paprsek.render.integrate.Integrator;
import cz.paprsek.render.integrate.Paths;
import cz.paprsek.render.integrate.Whitted;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.sample.PassSums;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.show.DepthRange;
import cz.paprsek.render.show.LayerTracer;
import cz.paprsek.render.show.ModeTracer;
import cz.paprsek.render.show.PathCounts;
import cz.paprsek.render.show.PathLayers;
import cz.paprsek.render.work.Desk;
import cz.paprsek.render.work.Workers;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import java.io.IOException;
import java.math.BigInteger;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;

/** One picture under way: its tiles, taken from a counter by any number of workers, and what they have in common. */
final class RenderJob implements Workers.Work {
    private static final int SIDE = TileStore.LARGEST_SIDE;
    /** Rays along each side of a block, about: how many are traced together. */
    private static final int TOGETHER = 8;
    /** In place of the column and row of a fault outside of any pixel. */
    private static final int NOWHERE = -1;

    private final RenderScene scene;
    private final RenderOptions options;
    private final RenderMonitor monitor;
    private final TileStore store;
    private final Image image;
    private final Film film;
    private final Eye eye;
    private final DepthRange depths;
    private final int block;
    private final int columns;
    private final int tiles;
    private final int tilesOfAllPasses;
    /** Whether each pixel ends when it is near enough: nobody knows after how many passes. */
    private final boolean isJudged;
    private final int stride;
    private final AtomicInteger next = new AtomicInteger();
    private final AtomicInteger done = new AtomicInteger();
    private final AtomicInteger told = new AtomicInteger();
    /** Passes over the picture that are complete. */
    private int passes;
    /** Which share of the pixels needs no more after them. */
    private double settledBefore;
    private volatile boolean stopped;
    /** What was thrown first, and in what pixel; noted in fields that are there already, because it may be that no memory is left. */
    private @Nullable Throwable fault;
    private int faultColumn = NOWHERE;
    private int faultRow = NOWHERE;
    /** What is told of it. */
    private List<float[]> noise = List.of();
    private RenderResult.Stats total = RenderResult.Stats.NONE;

    RenderJob(RenderScene scene, RenderOptions options, RenderMonitor monitor, TileStore store) {
        this.scene = scene;
        Require.that(scene.instants().isEmpty() || (options.mode() == RenderMode.SHADED && !options.isWatched()),
                "while the shutter is open, pictures show light alone: no mode, no layers, no transparency, no denoiser");
        eye = Eye.of(scene.scene().camera(), options.settings().width(), options.settings().height(), options.step());
        this.options = options;
        this.monitor = monitor;
        this.store = store;
        Tile region = options.region();
        image = options.transparent() ? Image.ofTransparent(region.width(), region.height()) : new Image(region.width(), region.height());
        film = new Film(image, region.x(), region.y(), options.layerPlanes(scene.scene()).size(), options.kept(scene.scene()));
        depths = options.mode() == RenderMode.DEPTH
                ? DepthRange.of(scene.world(), eye, RenderOptions.coarse(options.settings().width(), options.step()),
                        RenderOptions.coarse(options.settings().height(), options.step())) : DepthRange.NONE;
        block = Math.max(1, TOGETHER / (options.settings().isPath() ? (int) Math.ceil(Math.sqrt(options.settings().samples())) : options.settings().samples()));
        columns = (region.width() + SIDE - 1) / SIDE;
        tiles = columns * ((region.height() + SIDE - 1) / SIDE);
        isJudged = options.isInPasses() && options.settings().isAdaptive();
        tilesOfAllPasses = isJudged ? tiles : (int) Math.min(Integer.MAX_VALUE, (long) tiles * options.passes());
        stride = monitor.wantsRows() ? 1 : stride(tiles);
    }

    int tiles() {
        return tiles;
    }

    Image image() {
        return image;
    }

    /** What else is known of its pixels. */
    Layers layers() {
        Layers layers = Layers.ofSize(image.width(), image.height());
        List<String> planes = options.layerPlanes(scene.scene());
        for (int i = 0; i < planes.size(); i++) {
            layers = layers.with(planes.get(i), film.plane(i));
        }
        for (int i = 0; i < noise.size(); i++) {
            layers = layers.with(Denoiser.PLANES.get(i), noise.get(i));
        }
        return layers;
    }

    /** How near the pixels are to the truth; empty if they are not judged as paths are. */
    Optional<RenderResult.Certainty> certainty() {
        if (!options.isInPasses() || !options.isJudged()) {
            return Optional.empty();
        }
        PassSums sums = options.paths().newSums();
        float[] kept = new float[options.kept(scene.scene())];
        int within = 0;
        int untrusted = 0;
        double farthest = 0;
        for (int i = 0; i < pixels(); i++) {
            film.kept(options.region().x() + i % image.width(), options.region().y() + i / image.width(), kept);
            sums.load(kept, 0);
            double half = sums.interval();
            untrusted += half < 0 ? 1 : 0;
            within += half >= 0 && half <= options.settings().error() ? 1 : 0;
            farthest = Math.max(farthest, Math.abs(half));
        }
        return Optional.of(new RenderResult.Certainty((double) within / pixels(), farthest, (double) untrusted / pixels()));
    }

    boolean isComplete() {
        return done.get() == tiles;
    }

    /** How many tiles are done, those of passes that are complete included; of pixels that are judged, as many as those are that need no more. */
    private int told(int inThisPass) {
        if (!isJudged) {
            return (int) Math.min(tilesOfAllPasses, (long) passes * tiles + inThisPass);
        }
        double pass = (double) inThisPass / tiles;
        double settled = pass - (double) film.wanting() / pixels() + (1 - pass) * settledBefore;
        return told.accumulateAndGet((int) (tiles * settled), Math::max);
    }

    private int pixels() {
        return image.width() * image.height();
    }

    /** Makes ready for another pass, if one is to follow that which is complete. */
    boolean goesOn() {
        try {
            int wanting = film.beginPass();
            if (wanting == 0 || !monitor.passed(image, this::layers, passes + 1)) {
                return false;
            }
            settledBefore = 1 - (double) wanting / pixels();
        } catch (Throwable thrown) {
            fail(thrown);
            return false;
        }
        passes++;
        done.set(0);
        next.set(0);
        return true;
    }

    @Override
    public void cancel() {
        stopped = true;
    }

    private boolean cancelled() {
        return stopped || monitor.cancelled();
    }

    /** Renders tiles until none is left or the job is stopped. Whatever is thrown meanwhile is kept for {@link #throwFailure}. */
    @Override
    public void at(Desk desk) {
        try {
            renderTiles(desk);
        } catch (Throwable thrown) {
            fail(thrown);
        }
        if (hasFailed()) {
            desk.clear();
        }
    }

    private void renderTiles(Desk desk) {
        Integrator integrator = integrator(desk);
        integrator.begin(this::cancelled);
        for (int i = next.getAndIncrement(); i < tiles && !cancelled(); i = next.getAndIncrement()) {
            render(tile(i), integrator);
        }
        add(integrator.work());
    }

    /** Stops the job, which has failed; column and row of the pixel, if it was one. Only what is thrown first is kept. */
    private void fail(Throwable thrown, int column, int row) {
        stopped = true;
        synchronized (this) {
            if (fault == null) {
                fault = thrown;
                faultColumn = column;
                faultRow = row;
            }
        }
    }

    private synchronized boolean hasFailed() {
        return fault != null;
    }

    /** @throws IllegalStateException if a worker or the monitor has thrown something, with that as its cause */
    synchronized void throwFailure() {
        if (fault instanceof OutOfMemoryError exhausted) {
            throw Memory.exceeded(scene.scene(), options, exhausted);
        }
        if (fault != null) {
            String place = faultRow == NOWHERE ? "" : " at pixel " + faultColumn + ", " + faultRow;
            // What we say ourselves is a sentence, and needs no name before it.
            String what = fault instanceof IllegalStateException ? String.valueOf(fault.getMessage()) : fault.toString();
            throw new IllegalStateException("rendering failed" + place + ": " + what, fault);
        }
    }

    /** Takes the noise out of the picture, which is complete, or tells of it, if that is wished; false if it was stopped half-way, or failed. */
    boolean denoise(Workers workers) {
        if (!options.isGuided()) {
            return true;
        }
        try {
            Denoiser denoiser = new Denoiser(film, image, options.paths(), options.kept(scene.scene()), this::cancelled);
            if (options.denoised()) {
                monitor.denoising();
                return denoiser.run(workers, options.threads());
            }
            Optional<List<float[]>> told = denoiser.tell(workers, options.threads());
            noise = told.orElse(noise);
            return told.isPresent();
        } catch (RuntimeException | Error failed) {
            fail(failed);
            return false;
        }
    }

    synchronized RenderResult.Stats stats(double buildSeconds, double traceSeconds) {
        return new RenderResult.Stats(total.primary(), total.reflected(), total.refracted(), total.shadow(), total.hits(),
                buildSeconds, traceSeconds);
    }

    @Override
    public void fail(Throwable thrown) {
        fail(thrown, NOWHERE, NOWHERE);
    }

    private Integrator integrator(Desk desk) {
        RenderSettings settings = options.settings();
        // What is shown of things seen is no light whose spread would tell how many rays it takes; what is shown of rays is.
        RenderSettings shown = options.mode().scale().isPresent() ? settings : settings.withSamples(settings.samples()).withFilter(PixelFilter.BOX);
        List<Object> purpose = List.of(scene.world(), options.mode(), settings.withSize(1, 1), options.fixedSampler(), options.numbers(), depths, options.layers(), options.transparent(), options.isGuided());
        if (!scene.instants().isEmpty()) {
            return exposure();
        }
        return desk.integrator(purpose, () -> options.isInPasses() ? paths() : options.isWatched()
                ? new LayerTracer(scene.world(), settings.maxDepth(), Sampling.of(settings, options.fixedSampler()), options.layers(), options.transparent())
                : options.mode() == RenderMode.SHADED ? new Whitted(scene.world(), settings.maxDepth(), Sampling.of(settings, options.fixedSampler()))
                : new ModeTracer(scene.world(), options.mode(), settings.maxDepth(), Sampling.of(shown, options.fixedSampler()), depths, options.numbers()));
    }

    /** Of what moves; scratch that is not kept from one picture to the next, whose instants are others. */
    private Integrator exposure() {
        RenderSettings settings = options.settings();
        Sampling sampling = options.isInPasses() ? options.paths() : Sampling.of(settings, options.fixedSampler());
        List<Eye> eyes = scene.instants().stream().map(world -> Eye.of(world.scene().camera(), settings.width(), settings.height(), options.step())).toList();
        return new Exposure(scene.instants(), eyes, settings.maxDepth(), sampling);
    }

    private Integrator paths() {
        int depth = options.settings().maxDepth();
        return options.mode() != RenderMode.SHADED ? new PathCounts(scene.world(), options.mode(), depth, options.paths(), options.numbers())
                : options.isWatched() ? new PathLayers(scene.world(), depth, options.paths(), options.layers(), options.transparent(), options.isGuided()) : new Paths(scene.world(), depth, options.paths());
    }

    private synchronized void add(Integrator.Work work) {
        total = new RenderResult.Stats(total.primary() + work.primary(), total.reflected() + work.reflected(),
                total.refracted() + work.refracted(), total.shadow() + work.shadows(), total.hits() + work.hits(), 0, 0);
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

    private void render(Tile tile, Integrator integrator) {
        int x = NOWHERE;
        int y = NOWHERE;
        long raysBefore = integrator.rays();
        try {
            if (passes == 0 && store.load(inPicture(tile), passes, film)) {
                // Whether that is all there is to it, the next pass will tell.
                if (film.isInPasses()) {
                    film.wantMore(tile.width() * tile.height());
                }
                monitor.found(tile, image, told(done.incrementAndGet()), tilesOfAllPasses);
                return;
            }
            for (y = tile.y(); y < tile.y() + tile.height(); y += block) {
                for (x = tile.x(); x < tile.x() + tile.width(); x += block) {
                    integrator.block(eye, options.region().x() + x, options.region().y() + y,
                            Math.min(block, tile.x() + tile.width() - x), Math.min(block, tile.y() + tile.height() - y), film);
                    // Rays that lead to no others ask nobody whether to stop.
                    if (integrator.isCancelled() || cancelled()) {
                        return;
                    }
                }
            }
            // What is thrown from here on is of no pixel.
            y = NOWHERE;
            long rays = integrator.rays() - raysBefore;
            monitor.traced(rays);
            if (passes == 0 || rays > 0) {
                store.save(inPicture(tile), passes, film);
            }
            monitor.finished(tile, image, told(done.incrementAndGet()), tilesOfAllPasses);
        } catch (IOException unkept) {
            fail(unkept);
        } catch (Throwable thrown) {
            fail(thrown, x, y);
        }
    }

    private Tile inPicture(Tile tile) {
        return new Tile(options.region().x() + tile.x(), options.region().y() + tile.y(), tile.width(), tile.height());
    }
}
